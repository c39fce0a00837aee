// SPDX-License-Identifier: MIT
#pragma once

// The files of data/page: styles, in light and in dark, and the script of a page.
//
// figure.css: areas that meet differ in lightness too, for paper without colours: in grey, of 255,
// green is 230, sky 217, amber 196, purple 178 and orange 150. The hatching of a map has light
// lines for its darkest cells. In the dark the cells of a map have the same colours, and so have
// the words on them.
//
// page.css: the first figures stand in pairs. What follows flows through two columns, so that a
// last odd figure has tables beside it; a wide table goes across both.
//
// print.css: everything flows through the columns, the input as small print at the end. Letters are
// as large as those of the figures: 10 pixels are 7.5 points.
//
// sheet.css: of a specification, also inside the explorer's page. It is as wide as paper on a
// screen.
//
// figures.js: values under the pointer come from the drawing, by the mapping of the axes that the
// figure carries. Zooming changes the view of the plot and its ticks.

#include <string_view>

namespace stillpoint::figures {

#include "page_files.inc"

}  // namespace stillpoint::figures
