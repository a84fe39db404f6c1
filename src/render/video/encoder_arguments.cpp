#include "render/video/encoder_arguments.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tumble::render {

namespace {

using Arguments = std::vector<std::string>;

// A fixed number: the bytes of a video must not depend on the machine. Drawing is slower than two threads encode.
const char* const kThreads = "2";

constexpr double kMostGifRate = 50.0;  // frames/s: browsers show a frame of less than 0.02 s for 0.1 s

std::string decimal(double number) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, number, std::chars_format::fixed).ptr};
}

// Frames between two that can be decoded alone: a player seeks within 2 s.
std::string key_interval(double frames_per_second) {
    return std::to_string(std::clamp(std::lround(2.0 * frames_per_second), 1L, 600L));
}

void append(Arguments& arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
}

// sRGB frames as BT.709 in the range of television, which every player assumes for video of this size.
Arguments television_colours() {
    return {"-vf",
            "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "bt709",
            "-colorspace",
            "bt709",
            "-color_range",
            "tv"};
}

// superfast without CABAC and B-frames takes 0.8 of the time that superfast takes, and 0.6 of veryfast, for files 1.2
// and 2 times as large. The filter removes the message in which x264 writes its options, among them the number of
// threads.
Arguments mp4_arguments(const VideoSettings& settings, bool is_stream) {
    Arguments arguments = television_colours();
    append(arguments,
           {"-c:v", "libx264", "-preset", "superfast", "-crf", "20", "-x264-params", "cabac=0:bframes=0", "-threads",
            kThreads, "-g", key_interval(settings.frames_per_second), "-bsf:v", "filter_units=remove_types=6",
            "-movflags", is_stream ? "+frag_keyframe+empty_moov+default_base_moof" : "+faststart", "-f", "mp4"});
    return arguments;
}

Arguments webm_arguments(const VideoSettings& settings) {
    Arguments arguments = television_colours();
    append(arguments,
           {"-c:v", "libvpx-vp9", "-deadline", "realtime", "-cpu-used", "8", "-crf", "20", "-b:v", "0", "-row-mt", "1",
            "-threads", kThreads, "-g", key_interval(settings.frames_per_second), "-f", "webm"});
    return arguments;
}

// One palette for the whole video: a palette for each frame makes a file 1.6 times as large, and colours flicker.
Arguments gif_arguments(const VideoSettings& settings) {
    const std::string rate = settings.frames_per_second > kMostGifRate ? "fps=" + decimal(kMostGifRate) + "," : "";
    return {"-filter_complex",
            rate +
                "split[all][counted];[counted]palettegen=stats_mode=full[palette];"
                "[all][palette]paletteuse=dither=none:diff_mode=rectangle",
            "-loop",
            "0",
            "-f",
            "gif"};
}

Arguments apng_arguments() { return {"-pix_fmt", "rgb24", "-pred", "mixed", "-plays", "0", "-f", "apng"}; }

Arguments format_arguments(const VideoSettings& settings, bool is_stream) {
    switch (settings.format) {
        case VideoFormat::mp4: return mp4_arguments(settings, is_stream);
        case VideoFormat::webm: return webm_arguments(settings);
        case VideoFormat::gif: return gif_arguments(settings);
        case VideoFormat::apng: break;
    }
    return apng_arguments();
}

}  // namespace

std::vector<std::string> encoder_arguments(const VideoSettings& settings, const std::string& file) {
    // With a queue, ffmpeg reads the next frame while it encodes.
    Arguments arguments{"ffmpeg",
                        "-nostdin",
                        "-hide_banner",
                        "-loglevel",
                        "error",
                        "-xerror",
                        "-y",
                        "-f",
                        "rawvideo",
                        "-pixel_format",
                        "rgb0",
                        "-video_size",
                        std::to_string(settings.width) + "x" + std::to_string(settings.height),
                        "-framerate",
                        decimal(settings.frames_per_second),
                        "-thread_queue_size",
                        "4",
                        "-i",
                        "pipe:0"};
    append(arguments, format_arguments(settings, file.empty()));
    append(arguments, {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact",
                       file.empty() ? "pipe:1" : "file:" + file});
    return arguments;
}

}  // namespace tumble::render
