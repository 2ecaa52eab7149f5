#pragma once

#include "core/packed/front_schedule.h"
#include "core/packed/packed_query.h"
#include "scb/packed_front.h"

namespace scb {

struct PackedFront::Parts {
    FrontSchedule schedule;
    PackedLists pairs;
};

}  // namespace scb
