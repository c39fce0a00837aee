// SPDX-License-Identifier: MIT

// The Archivo Estandar de Aceleracion, version 2.0, of the Mexican networks (UNAM, CENAPRED, CIRES):
// 109 lines of header, most of them "KEY : value" with a value for each channel behind a '/', then a
// row of accelerations for each instant.

#include "acceleration_units.hpp"
#include "channel.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <vector>

namespace stillpoint::records {

namespace {

constexpr std::size_t asa_header_lines = 109;

bool is_asa(RecordReader reader) {
  constexpr std::size_t title = 10;  // it is in line 7
  while (reader.number() < title && reader.next()) {
    if (upper_case(reader.line()).find("ARCHIVO ESTANDAR DE ACELERACION") != std::string::npos) {
      return true;
    }
  }
  return false;
}

/// The words of "KEY, C1-C6 (s) : /0.01/0.01/0.01" or "UNIDADES DE LOS DATOS : ACELERACION (Gal)".
std::vector<HeaderText> asa_values(const std::vector<RecordReader>& header, std::string_view key) {
  const HeaderText all = text_of(header, key);
  std::vector<HeaderText> values;
  for (const std::string_view word : words_of(after_colon(all.text), "/() \t")) {
    values.push_back({word, all.reader});
  }
  if (values.empty()) {
    all.reader.refuse(fmt::format("{} has no value", key));
  }
  return values;
}

RecordFile read_asa(RecordReader& reader) {
  std::vector<RecordReader> header;
  while (reader.number() < asa_header_lines) {
    skip(reader, 1);
    header.push_back(reader);
  }
  const auto counts = asa_values(header, "NUM. TOTAL DE MUESTRAS");
  const auto steps = asa_values(header, "INTERVALO DE MUESTREO");
  const auto names = asa_values(header, "ORIENTACION C1-C6");
  const std::size_t wanted = chosen_channel(
      names[0].reader, counts.size(), std::string(after_colon(names[0].reader.line())));
  ...
}

}  // namespace
}
