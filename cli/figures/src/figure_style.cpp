// SPDX-License-Identifier: MIT
#include "page_files.hpp"

#include <stillpoint/figures/figure.hpp>

namespace stillpoint::figures {

std::string_view figure_style() noexcept {
  return figure_css;
}

std::string_view dark_figure_style() noexcept {
  return figure_dark_css;
}

}  // namespace stillpoint::figures
