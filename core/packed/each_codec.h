#pragma once

#include "scb/node_codec.h"

/// Expands X(Codec) for every codec, to instantiate templates.
#define SCB_FOR_EACH_CODEC(X) \
    X(FloatCodec<2>)          \
    X(FloatCodec<4>)          \
    X(FloatCodec<8>)          \
    X(QuantizedCodec<2>)      \
    X(QuantizedCodec<4>)      \
    X(QuantizedCodec<8>)
