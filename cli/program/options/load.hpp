// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint::cli {

/// Which loads, or pulses, an option shapes; a wave is a harmonic or a pulse.
enum class Load { none, harmonic, pulse, wave, record };

}  // namespace stillpoint::cli
