#pragma once

#include "scb/node_codec.h"

/// Expands X(Codec) for every codec of AnyCodec, to instantiate templates. X takes any number of
/// arguments: a codec may have a comma.
#define SCB_FOR_EACH_CODEC(X)  \
    X(FloatCodec<2>)           \
    X(FloatCodec<4>)           \
    X(FloatCodec<8>)           \
    X(QuantizedCodec<2>)       \
    X(QuantizedCodec<4>)       \
    X(QuantizedCodec<8>)       \
    X(FloatCodec<2, Scb2>)     \
    X(FloatCodec<4, Scb2>)     \
    X(FloatCodec<8, Scb2>)     \
    X(QuantizedCodec<2, Scb2>) \
    X(QuantizedCodec<4, Scb2>) \
    X(QuantizedCodec<8, Scb2>)

namespace scb {
template <class>
struct CodecOfList {};
static_assert(std::variant_size_v<AnyCodec<CodecOfList>> == 12, "the list above has them all");
}  // namespace scb
