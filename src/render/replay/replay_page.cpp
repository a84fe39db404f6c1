#include "render/replay/replay_page.hpp"

#include <libdeflate.h>

#include <memory>
#include <new>

#include "debug/check.hpp"
#include "render/output/base64.hpp"
#include "render/replay/page_colors.hpp"

namespace tumble::render {

// Made from the files in page/ by CMake.
extern const std::string_view kReplayPageText, kPairPageText;

namespace {

// As the browser's DecompressionStream("deflate") reads it: RFC 1950.
std::string deflated(std::string_view bytes) {
    constexpr int kLevel = 12;  // 9 takes a fifth of the time, for 8 % more bytes
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    std::string packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    packed.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
    TUMBLE_CHECK(packed.size() > 0u);
    return packed;
}

std::string replaced(std::string_view text, std::string_view mark, std::string_view by) {
    const std::size_t at = text.find(mark);
    TUMBLE_CHECK(at < text.size());
    return std::string(text.substr(0, at)) + std::string(by) + std::string(text.substr(at + mark.size()));
}

}  // namespace

std::string replay_page(std::string_view states, std::string_view contacts) {
    const std::string page = replaced(kReplayPageText, "%COLORS%", page_colors());
    const std::string with_states = replaced(page, "%STATES%", base64(deflated(states)));
    return replaced(with_states, "%CONTACTS%", contacts.empty() ? "" : base64(deflated(contacts)));
}

std::string pair_page(std::string_view states_a, std::string_view states_b, std::string_view numbers) {
    std::string page = replaced(kPairPageText, "%COLORS%", page_colors());
    page = replaced(page, "%STATES_A%", base64(deflated(states_a)));
    page = replaced(page, "%STATES_B%", base64(deflated(states_b)));
    return replaced(page, "%NUMBERS%", base64(deflated(numbers)));
}

}  // namespace tumble::render
