#include "render/files/image_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string>

#include "scb/error.h"

namespace {

// Rendered pictures are encoded in a quarter of the time that stb's own deflate takes, and a fifth
// smaller.
unsigned char* deflate_for_stb(unsigned char* data, int size, int* packed_size, int level) {
    uLongf capacity = compressBound(static_cast<uLong>(size));
    auto* packed = static_cast<unsigned char*>(std::malloc(capacity));
    if (packed && compress2(packed, &capacity, data, static_cast<uLong>(size), level) != Z_OK) {
        std::free(packed);
        packed = nullptr;
    }
    *packed_size = static_cast<int>(capacity);
    return packed;
}

/// The largest block that stb may allocate, in this thread. If compressed data have no end, stb
/// reads zeros behind them for as long as it gets memory.
thread_local std::size_t most_for_stb = 0;

void* block_for_stb(void* old, std::size_t size) {
    if (size > most_for_stb) return nullptr;
    void* const block = std::realloc(old, size);
    if (!block) throw std::bad_alloc();
    return block;
}

}  // namespace

#define STBI_MALLOC(size) block_for_stb(nullptr, size)
#define STBI_REALLOC(block, size) block_for_stb(block, size)
#define STBI_FREE(block) std::free(block)
#define STBIW_ZLIB_COMPRESS deflate_for_stb
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb_image.h>
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace scb::render {

namespace {

// Three rendered pictures at 1280x720: zlib takes 7 ms at level 2, 10 ms at level 4 (files 7 to 13
// % smaller) and 15 to 22 ms at level 6 (another 1 to 6 %). Among the filters none, sub, up and
// paeth, each used for all lines, up comes within 2 % of the smallest file, and stb need not try
// them line by line.
constexpr int compression_level = 4;
constexpr int filter_up = 2;

void append_bytes(void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
}

void append_number(std::string& bytes, std::size_t number) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 255);
}

/// A chunk of a PNG file: tEXt for plain characters, else iTXt.
std::string text_chunk(const PngText& text) {
    const bool plain = std::all_of(text.text.begin(), text.text.end(),
                                   [](char c) { return c >= ' ' && c <= '~'; });
    std::string content = plain ? "tEXt" : "iTXt";
    content += text.keyword + '\0';
    // Not compressed, without a language, and without a translated keyword.
    if (!plain) content += std::string(4, '\0');
    content += text.text;
    std::string chunk;
    append_number(chunk, content.size() - std::strlen("tEXt"));
    chunk += content;
    append_number(chunk, crc32(0, reinterpret_cast<const Bytef*>(content.data()),
                               static_cast<uInt>(content.size())));
    return chunk;
}

std::vector<std::uint8_t> encode(const std::uint8_t* pixels, int width, int height, int channels,
                                 const std::vector<PngText>& texts) {
    // stb keeps these in globals, which threads share.
    static const bool configured = [] {
        stbi_write_png_compression_level = compression_level;
        stbi_write_force_png_filter = filter_up;
        return true;
    }();
    static_cast<void>(configured);
    std::vector<std::uint8_t> bytes;
    if (!stbi_write_png_to_func(append_bytes, &bytes, width, height, channels, pixels,
                                width * channels))
        throw std::bad_alloc();
    // Texts are before the pixels, behind the signature and the header, so that a reader of texts
    // need not read the pixels.
    constexpr std::ptrdiff_t header_end = 8 + 25;
    std::string chunks;
    for (const PngText& text : texts) chunks += text_chunk(text);
    bytes.insert(bytes.begin() + header_end, chunks.begin(), chunks.end());
    return bytes;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, const std::vector<PngText>& texts) {
    bool opaque = true;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque &= image.rgba[i] == 255;
    if (!opaque) return encode(image.rgba.data(), image.width, image.height, 4, texts);
    std::vector<std::uint8_t> rgb(image.rgba.size() / 4 * 3);
    for (std::size_t from = 0, to = 0; from < image.rgba.size(); from += 4, to += 3)
        std::memcpy(&rgb[to], &image.rgba[from], 3);
    return encode(rgb.data(), image.width, image.height, 3, texts);
}

std::vector<std::uint8_t> encode_png(const IdImage& image, const std::vector<PngText>& texts) {
    std::vector<std::uint8_t> packed;
    packed.reserve(image.ids.size() * 4);
    for (const std::uint32_t id : image.ids)
        for (int shift = 0; shift < 32; shift += 8)
            packed.push_back(static_cast<std::uint8_t>(id >> shift));
    return encode(packed.data(), image.width, image.height, 4, texts);
}

namespace {

/// The largest block that the decoder, which doubles its blocks, needs for a valid picture: its
/// pixels, at most the 1032 times that deflate can expand the data, or its data. `header` has the
/// width from byte 16 on, then the height; scb draws neither above 2^14.
std::size_t most_of(const std::array<unsigned char, 25>& header, std::uintmax_t file_size) {
    const auto number = [&](std::size_t at) {
        std::size_t value = 0;
        for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | header[i];
        return value;
    };
    constexpr std::size_t small = 1 << 16, most_side = 1 << 14, most_packed = 1032;
    const std::size_t width = std::min(number(16), most_side),
                      height = std::min(number(20), most_side);
    return small +
           2 * std::max(file_size, std::min(height * (4 * width + 1), most_packed * file_size));
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw InputError("\"" + path.string() + "\" is not a regular file; save it to one first.");
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                         std::fclose);
    if (!file)
        throw InputError("Cannot read \"" + path.string() + "\": " + std::strerror(errno) + ".");
    // The header is the first chunk; its ninth byte is the depth.
    std::array<unsigned char, 25> start{};
    const bool has_header = std::fread(start.data(), 1, start.size(), file.get()) == start.size() &&
                            std::memcmp(&start[12], "IHDR", 4) == 0;
    if (const int depth = start[24]; has_header && depth != 8)
        throw InputError("\"" + path.string() + "\" has " + std::to_string(depth) +
                         " bits a channel, and only 8 bits can be compared; save it with 8.");
    std::rewind(file.get());
    most_for_stb = most_of(start, std::filesystem::file_size(path));
    Image image;
    int channels = 0;
    std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_file(file.get(), &image.width, &image.height, &channels, 4),
        stbi_image_free);
    if (!pixels) {
        // The decoder has no message for some damage, and reads bytes behind the end as a chunk
        // without a name.
        const char* const words = stbi_failure_reason();
        std::string reason = words == nullptr ? "no reason given" : words;
        // The message may quote the file.
        for (char& c : reason)
            if (c < ' ' || c > '~') c = '?';
        const bool is_cut_off = reason.empty() || reason[0] == ' ' || reason == "outofdata";
        throw InputError("\"" + path.string() + "\" is " +
                         (!has_header  ? "not a PNG file."
                          : is_cut_off ? "not a whole PNG file: it ends too early."
                          : reason == "outofmem"
                              ? "a damaged PNG file: it holds more than a picture of its size."
                              : "a damaged PNG file: " + reason + "."));
    }
    const std::size_t size =
        4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgba.assign(pixels.get(), pixels.get() + size);
    return image;
}

IdImage unpack_ids(const Image& image) {
    IdImage result{image.width, image.height, {}};
    result.ids.reserve(image.rgba.size() / 4);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        result.ids.push_back(image.rgba[i] | static_cast<std::uint32_t>(image.rgba[i + 1]) << 8 |
                             static_cast<std::uint32_t>(image.rgba[i + 2]) << 16 |
                             static_cast<std::uint32_t>(image.rgba[i + 3]) << 24);
    return result;
}

}  // namespace scb::render
