// Owns a compressor of libdeflate.
#pragma once

#include <libdeflate.h>

#include <memory>

namespace tumble::render {

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

using Compressor = std::unique_ptr<libdeflate_compressor, FreeCompressor>;

}  // namespace tumble::render
