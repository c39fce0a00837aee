// SPDX-License-Identifier: MIT
#include "figure_parts.hpp"

#include <zlib.h>

#include <cassert>

namespace stillpoint::figures {

namespace {

void add_word(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes += static_cast<char>(static_cast<unsigned char>(value >> static_cast<unsigned>(shift)));
  }
}

const Bytef* bytes_of(const std::string& text) {
  return reinterpret_cast<const Bytef*>(text.data());
}

void add_chunk(std::string& png, std::string_view type, std::string_view data) {
  const std::string body = std::string(type) + std::string(data);
  add_word(png, static_cast<std::uint32_t>(data.size()));
  png += body;
  add_word(png,
           static_cast<std::uint32_t>(::crc32(0, bytes_of(body), static_cast<uInt>(body.size()))));
}

/// The pixels of a cell, across and down: many, because a printed image is smoothed by one pixel.
std::int64_t scale_of(const FigureMap& map) {
  constexpr std::int64_t fine = 1200;
  return std::max<std::int64_t>(1, fine / std::max(map.columns, map.rows));
}

std::string header(const FigureMap& map) {
  std::string data;
  add_word(data, static_cast<std::uint32_t>(scale_of(map) * map.columns));
  add_word(data, static_cast<std::uint32_t>(scale_of(map) * map.rows));
  return data + std::string("\x08\x03\0\0\0", 5);  // 8 bits, palette
}

std::string palette(const FigureMap& map) {
  std::string data;
  for (const MapShade& shade : map.palette) {
    for (std::size_t i = 1; i < 7; i += 2) {
      data += static_cast<char>(std::stoi(shade.colour.substr(i, 2), nullptr, 16));
    }
  }
  return data;
}

/// From the top row down, each after its filter byte: none, or for the same row again, the
/// difference from the one above.
std::string compressed_rows(const FigureMap& map) {
  std::string plain;
  const auto scale = static_cast<std::size_t>(scale_of(map));
  const auto columns = static_cast<std::size_t>(map.columns);
  for (auto row = static_cast<std::size_t>(map.rows); row-- > 0;) {
    plain += '\0';
    for (std::size_t column = 0; column < columns; ++column) {
      plain.append(scale, static_cast<char>(map.cells[row * columns + column]));
    }
    for (std::size_t again = 1; again < scale; ++again) {
      plain += '\2' + std::string(scale * columns, '\0');
    }
  }
  uLongf size = ::compressBound(plain.size());
  std::string packed(size, '\0');
  [[maybe_unused]] const int status =
      ::compress2(reinterpret_cast<Bytef*>(packed.data()), &size, bytes_of(plain), plain.size(), 9);
  assert(status == Z_OK);
  packed.resize(size);
  return packed;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned word = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      word = word << 8U | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += i + j > bytes.size() ? '=' : letters[word >> (18U - 6U * j) & 63U];
    }
  }
  return text;
}

}  // namespace

std::string map_base64(const FigureMap& map) {
  std::string png("\x89PNG\r\n\x1a\n", 8);
  add_chunk(png, "IHDR", header(map));
  add_chunk(png, "PLTE", palette(map));
  add_chunk(png, "IDAT", compressed_rows(map));
  add_chunk(png, "IEND", "");
  return base64(png);
}

}  // namespace stillpoint::figures
