// SPDX-License-Identifier: MIT
#include <stillpoint/figures/figure.hpp>

namespace stillpoint::figures {

// Areas that meet differ in lightness too, for paper without colours: in grey, of 255, green is
// 230, sky 217, amber 196, purple 178 and orange 150. The hatching of a map has light lines for its
// darkest cells.
std::string_view figure_style() noexcept {
  return R"(
.figure text{font:13px "DejaVu Sans",Arial,sans-serif;fill:#222}
.figure .title{font-weight:bold}
.figure .note{paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}
.figure .paper{fill:#fff}
.figure .frame{fill:none;stroke:#777}
.figure .grid{fill:none;stroke:#e3e3e3}
.figure .curve{fill:none;stroke:currentColor;stroke-width:1.8;vector-effect:non-scaling-stroke;stroke-linejoin:round}
.figure .halo{fill:none;stroke:#fff;stroke-width:4;vector-effect:non-scaling-stroke;stroke-linejoin:round}
.figure .dashed{stroke-dasharray:7 4}
.figure .dotted{stroke-dasharray:2 3}
.figure .area{fill:currentColor;fill-opacity:.3;stroke:currentColor;stroke-opacity:.6;vector-effect:non-scaling-stroke}
.figure .area.green{fill-opacity:.15}.figure .area.amber{fill-opacity:.42}.figure .area.purple{fill-opacity:.54}.figure .area.orange{fill-opacity:.68}
.figure .box{fill:#7fb9da;stroke:currentColor;stroke-width:1.8;vector-effect:non-scaling-stroke}
.figure .hatch{stroke:currentColor;stroke-width:1;fill:none;stroke-opacity:.8}
.figure .thin{stroke:currentColor;stroke-width:.8;vector-effect:non-scaling-stroke}
.figure .over{stroke:#222;stroke-width:1;stroke-opacity:.6;fill:none}.figure .over.light{stroke:#fff}
.figure .leader{stroke:#777;stroke-width:.8;vector-effect:non-scaling-stroke}
.figure .lens{fill:none;stroke:#777;stroke-dasharray:3 2}
.figure .band{fill:currentColor;fill-opacity:.25}
.figure .disc{fill:currentColor;stroke:#fff;stroke-width:.8}
.figure .ring{fill:none;stroke:currentColor;stroke-width:1.8}
.figure .cell{stroke:#777}
.figure image{image-rendering:pixelated}
.figure .blue{color:#0072b2}.figure .orange{color:#c04a00}.figure .green{color:#00805c}
.figure .purple{color:#a0527f}.figure .sky{color:#3a96cc}.figure .amber{color:#a66f00}
.figure .grey{color:#666}
)";
}

// The cells of a map have the same colours as in light, and so have the words on them.
std::string_view dark_figure_style() noexcept {
  return R"(
.figure text{fill:#ddd}
.figure .note{stroke:#14181d}
.figure .note.on-map{fill:#222;stroke:#fff}
.figure .paper{fill:#14181d}
.figure .grid{stroke:#2c3239}
.figure .halo{stroke:#14181d}
.figure .disc{stroke:#14181d}
.figure .box{fill:#436f91}
.figure .blue{color:#56a8f0}.figure .orange{color:#ff8a3d}.figure .green{color:#2bc492}
.figure .purple{color:#e39ac4}.figure .sky{color:#8fd3f5}.figure .amber{color:#f0b429}
.figure .grey{color:#a8a8a8}
)";
}

}  // namespace stillpoint::figures
