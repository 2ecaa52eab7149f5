#pragma once

#include <cstddef>
#include <string_view>

/// Declares, at file scope, a file that CMake's scb_embed has put into the library.
#define SCB_DECLARE_EMBEDDED(SYMBOL) \
    extern "C" const char scb_embedded_##SYMBOL[], scb_embedded_##SYMBOL##_end[];

/// The bytes of the file.
#define SCB_EMBEDDED(SYMBOL)                                                                       \
    std::string_view(scb_embedded_##SYMBOL, static_cast<std::size_t>(scb_embedded_##SYMBOL##_end - \
                                                                     scb_embedded_##SYMBOL))
