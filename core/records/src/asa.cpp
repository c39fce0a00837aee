// SPDX-License-Identifier: MIT

// The Archivo Estandar de Aceleracion, version 2.0, of the Mexican networks (UNAM, CENAPRED,
// CIRES): 109 lines of header, most of them "KEY : value" with a value for each channel behind a
// '/', then a row of accelerations for each instant.

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

/// The value of each channel, of "KEY, C1-C6 (s) : /0.01/0.01/0.01".
std::vector<HeaderText> asa_list(const std::vector<RecordReader>& header, std::string_view key) {
  const HeaderText all = text_of(header, key);
  std::vector<HeaderText> list;
  for (const std::string_view word : words_of(after_colon(all.text), "/ \t")) {
    list.push_back({word, all.reader});
  }
  return list;
}

RecordFile read_asa(RecordReader& reader) {
  std::vector<RecordReader> header;
  while (reader.number() < asa_header_lines) {
    skip(reader, 1);
    header.push_back(reader);
  }
  const auto counts = asa_list(header, "NUM. TOTAL DE MUESTRAS");
  const auto steps = asa_list(header, "INTERVALO DE MUESTREO");
  const auto names = asa_list(header, "ORIENTACION");
  if (counts.empty() || steps.size() < counts.size() || names.size() < counts.size()) {
    reader.refuse(
        "INTERVALO DE MUESTREO and ORIENTACION must have as many values as NUM. TOTAL DE MUESTRAS");
  }
  const std::size_t wanted =
      chosen_channel(names[0].reader, counts.size(),
                     fmt::format("the columns are {}",
                                 printable(after_colon(names[0].reader.line()), longest_word)));
  const HeaderText unit = text_of(header, "UNIDADES DE LOS DATOS");  // ACELERACION (cm/s/s), or Gal
  const auto words = words_of(after_colon(unit.text), "()");
  const RecordUnits units = read_units(unit.reader, words.empty() ? "" : trimmed(words.back()));
  return read_described(
      reader, {"NUM. TOTAL DE MUESTRAS", counts[wanted]}, {"INTERVALO DE MUESTREO", steps[wanted]},
      units, unit.reader.number(), {.columns = counts.size(), .column = wanted},
      fmt::format("{}, {}", after_colon(text_of(header, "CLAVE DE LA ESTACION").text),
                  names[wanted].text));
}

}  // namespace

constinit const RecordFormat asa_format{"ASA", ".ASA", is_asa, read_asa, true};

}  // namespace stillpoint::records
