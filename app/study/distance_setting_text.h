#pragma once

#include <string>

#include "app/study/distance_setting.h"

namespace scb::app {

/// "scb2, split cost, order hybrid, quantized8". `is_within`: the queries have no order.
std::string setting_words(const DistanceSetting& setting, bool is_within);

/// The options of `scb distance`: the volume and the split, and what differs from the default:
/// " --volume scb2 --split cost --layout quantized8".
std::string distance_options(const DistanceSetting& setting);

}  // namespace scb::app
