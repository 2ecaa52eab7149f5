#pragma once

#include "core/front_schedule.h"
#include "core/packed_front.h"
#include "core/packed_query.h"

namespace scb {

struct PackedFront::Parts {
    FrontSchedule schedule;
    PackedLists pairs;
};

}  // namespace scb
