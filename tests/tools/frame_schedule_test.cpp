#include "tools/run/frame_schedule.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <initializer_list>

using tumble::tools::FrameSchedule;

TEST_CASE("a run has floor(duration x fps) + 1 frames") {
    CHECK(FrameSchedule{5.0, 60.0, 60.0}.frame_count() == 301);
    CHECK(FrameSchedule{0.0, 60.0, 60.0}.frame_count() == 1);
    CHECK(FrameSchedule{0.99, 2.0, 60.0}.frame_count() == 2);
    // 0.29 x 100 is 28.999999999999996 in double.
    CHECK(FrameSchedule{0.29, 100.0, 60.0}.frame_count() == 30);
}

TEST_CASE("frame k shows step round(k x rate / fps)") {
    const FrameSchedule cinema{5.0, 24.0, 60.0};
    CHECK(cinema.step_of_frame(0) == 0);
    CHECK(cinema.step_of_frame(1) == 3);  // 2.5
    CHECK(cinema.step_of_frame(2) == 5);
    CHECK(cinema.step_of_frame(120) == 300);
    CHECK_FALSE(cinema.repeats_frames());
    const FrameSchedule slow_motion{1.0, 240.0, 60.0};
    CHECK(slow_motion.step_of_frame(1) == 0);
    CHECK(slow_motion.step_of_frame(2) == 1);
    CHECK(slow_motion.repeats_frames());
}

TEST_CASE("no frame shows a step beyond the last, and no frame is left out") {
    for (const double duration : {0.0, 0.1, 0.29, 1.0, 3.7, 10.0})
        for (const double fps : {1.0, 23.976, 24.0, 59.94, 60.0, 90.0})
            for (const double rate : {30.0, 60.0, 100.0, 240.0}) {
                const FrameSchedule schedule{duration, fps, rate};
                std::uint64_t before = 0;
                for (std::uint64_t frame = 0; frame < schedule.frame_count(); ++frame) {
                    CHECK(schedule.step_of_frame(frame) >= before);
                    before = schedule.step_of_frame(frame);
                }
                CHECK(before <= schedule.step_count());
            }
}
