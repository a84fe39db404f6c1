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

TEST_CASE("slow motion shows its part of the time with more frames, and the rest as before") {
    // 2 s at 10 frames/s: 1 s, then 0.5 s at a fifth of the speed, which is 2.5 s on screen, then 0.5 s.
    const FrameSchedule schedule{2.0, 10.0, 100.0, {{1.0, 1.5, 0.2}}};
    CHECK(schedule.frame_count() == 41);
    CHECK(schedule.step_of_frame(9) == 90);
    CHECK(schedule.step_of_frame(10) == 100);
    CHECK(schedule.step_of_frame(11) == 102);  // 0.1 s on screen are 0.02 s
    CHECK(schedule.step_of_frame(35) == 150);
    CHECK(schedule.step_of_frame(36) == 160);
    CHECK(schedule.step_of_frame(40) == 200);
    CHECK(schedule.speed_of_frame(9) == 1.0);
    CHECK(schedule.speed_of_frame(10) == 0.2);
    CHECK(schedule.speed_of_frame(34) == 0.2);
    CHECK(schedule.speed_of_frame(35) == 1.0);
    CHECK_FALSE(schedule.repeats_frames());                                       // 100 x 0.2 >= 10
    CHECK(FrameSchedule{2.0, 10.0, 100.0, {{1.0, 1.5, 0.09}}}.repeats_frames());  // 9 steps/s on screen
}

TEST_CASE("slow motion of several parts reaches the last step, and a part after the end counts for nothing") {
    // 1 s and its parts: 0.2 s at half the speed are 0.4 s, 0.3 s at a tenth 3 s: 3.9 s on screen.
    const FrameSchedule schedule{1.0, 50.0, 500.0, {{0.1, 0.3, 0.5}, {0.6, 0.9, 0.1}, {2.0, 3.0, 0.1}}};
    CHECK(schedule.frame_count() == 196);
    std::uint64_t before = 0;
    for (std::uint64_t frame = 0; frame < schedule.frame_count(); ++frame) {
        CHECK(schedule.step_of_frame(frame) >= before);
        before = schedule.step_of_frame(frame);
    }
    CHECK(before == 500);
    CHECK_FALSE(FrameSchedule{1.0, 50.0, 500.0, {{2.0, 3.0, 0.01}}}.repeats_frames());
    // A part that the end of the run cuts: 0.5 s, and 0.5 s at half the speed.
    CHECK(FrameSchedule{1.0, 50.0, 500.0, {{0.5, 2.0, 0.5}}}.frame_count() == 76);
}
