// `tumble doctor`, and the rest of the command line, on machines without OSMesa, EGL, fonts or ffmpeg. A library is
// hidden by a file of its name that is none, a program by an empty search path, fonts by a mount of this process alone.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "process.hpp"

using nlohmann::json;
using tumble::test::Answer;
using tumble::test::Folder;
using tumble::test::run;
using tumble::test::run_tumble;
using tumble::test::tumble_command;

namespace {

const std::string kPendulum = TUMBLE_SOURCE_DIR "/scenes/pendulum.json";

const char* const kOsmesaNames[] = {"libOSMesa.so.8", "libOSMesa.so"};
const char* const kEglNames[] = {"libEGL.so.1", "libEGL.so"};

// A machine without some of what tumble uses.
class Machine {
public:
    void hide_osmesa() { hide(kOsmesaNames); }
    void hide_egl() { hide(kEglNames); }
    void hide_programs() { environment_.push_back("PATH=/nowhere"); }
    void hide_temporary_folder() { environment_.push_back("TMPDIR=/nowhere"); }

    Answer answer(const std::vector<std::string>& arguments) const {
        std::vector<std::string> command{"/usr/bin/env", "LD_LIBRARY_PATH=" + folder_.path().string()};
        command.insert(command.end(), environment_.begin(), environment_.end());
        for (const std::string& word : tumble_command(arguments)) command.push_back(word);
        return run(command);
    }

    json doctor(int code, const std::string& needed = "frames,text,videos") const {
        const Answer found = answer({"doctor", "--json", "--need", needed});
        CHECK_MESSAGE(found.code == code, (found.out + found.err));
        return json::parse(found.out);
    }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }

private:
    template <std::size_t Count>
    void hide(const char* const (&names)[Count]) {
        for (const char* const name : names) folder_.write(name, "no library");
    }

    Folder folder_;
    std::vector<std::string> environment_;
};

std::vector<std::string> shot(const std::string& file, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"shot", kPendulum, "-o", file, "--size", "640x360"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

bool has(const Answer& answer, const std::string& text) { return answer.err.find(text) != std::string::npos; }

}  // namespace

TEST_CASE("the doctor finds everything that the tests need") {
    const Machine whole;
    const json report = whole.doctor(0);
    for (const char* const part : {"frames", "text", "videos"}) CHECK(report[part] == true);
    REQUIRE(report["back_ends"].size() == 2);
    CHECK(report["back_ends"][0]["name"] == "osmesa");
    CHECK(report["back_ends"][1]["works"] == true);
    CHECK(report["encoders"].size() == 4);
    CHECK(report["machine"]["simd"].get<std::string>() != "");
    CHECK(report["instruction_sets"][0] == "baseline");
    const Answer text = run_tumble({"doctor"});
    CHECK(text.out.find("works: frames yes, text in frames yes, videos yes\n") != std::string::npos);
    CHECK(run_tumble({"doctor", "--need", "sound"}).code == 2);
}

TEST_CASE("without OSMesa, EGL draws the frames") {
    Machine machine;
    machine.hide_osmesa();
    const json report = machine.doctor(0);
    CHECK(report["back_ends"][0]["works"] == false);
    CHECK(report["back_ends"][0]["package"] == "libosmesa6");
    CHECK(report["frames"] == true);
    CHECK(machine.answer(shot(machine.file("auto.png"))).code == 0);
    CHECK(machine.answer(shot(machine.file("egl.png"), {"--renderer", "egl"})).code == 0);
    CHECK(tumble::test::read_text(machine.file("auto.png")) == tumble::test::read_text(machine.file("egl.png")));
    const Answer refused = machine.answer(shot(machine.file("a.png"), {"--renderer", "osmesa"}));
    CHECK(refused.code == 5);
    CHECK(has(refused, "apt install libosmesa6"));
    CHECK(machine.answer(shot(machine.file("a.png"), {"--renderer", "gpu"})).code == 2);
}

TEST_CASE("without EGL, OSMesa draws the frames") {
    Machine machine;
    machine.hide_egl();
    CHECK(machine.doctor(0)["back_ends"][1]["works"] == false);
    CHECK(machine.answer(shot(machine.file("auto.png"))).code == 0);
    const Answer refused = machine.answer(shot(machine.file("a.png"), {"--renderer", "egl"}));
    CHECK(refused.code == 5);
    CHECK(has(refused, "apt install libegl1"));
}

TEST_CASE("without any OpenGL, everything but frames works, and the doctor says what to install") {
    Machine machine;
    machine.hide_osmesa();
    machine.hide_egl();
    const json report = machine.doctor(5);
    CHECK(report["frames"] == false);
    CHECK(report["videos"] == true);
    machine.doctor(0, "text,videos");
    const Answer text = machine.answer({"doctor"});
    CHECK(text.code == 5);
    CHECK(text.out.find("apt-get install libosmesa6\n") != std::string::npos);
    CHECK(text.out.find("apt-get install libegl1 libgl1-mesa-dri\n") != std::string::npos);
    const Answer frames = machine.answer(shot(machine.file("a.png")));
    CHECK(frames.code == 5);
    CHECK(has(frames, "libosmesa6"));
    CHECK(has(frames, "libegl1"));
    CHECK(machine.answer({"--version"}).code == 0);
    CHECK(machine.answer({"check", kPendulum}).code == 0);
    CHECK(machine
              .answer({"run", kPendulum, "-o", machine.file("labels"), "--no-frames", "--duration", "0.1", "--masks",
                       "--boxes"})
              .code == 0);
    CHECK(std::filesystem::exists(machine.file("labels/masks/mask_000006.png")));
}

TEST_CASE("without ffmpeg, everything but videos works") {
    Machine machine;
    machine.hide_programs();
    const json report = machine.doctor(5);
    CHECK(report["videos"] == false);
    CHECK(report["frames"] == true);
    for (const json& encoder : report["encoders"]) {
        CHECK(encoder["works"] == false);
        CHECK(encoder["package"] == "ffmpeg");
    }
    machine.doctor(0, "frames,text");
    CHECK(machine.answer(shot(machine.file("a.png"))).code == 0);
    const Answer video =
        machine.answer({"run", kPendulum, "-o", machine.file("out"), "--no-frames", "--video", machine.file("a.mp4")});
    CHECK(video.code == 5);
    CHECK(has(video, "ffmpeg"));
}

TEST_CASE("without fonts, frames without text work") {
    const std::string hide = "mount -t tmpfs none /usr/share/fonts && exec \"$@\"";
    const std::vector<std::string> hidden{"unshare", "--map-root-user", "--mount", "sh", "-c", hide, "sh"};
    const auto answer = [&](const std::vector<std::string>& arguments) {
        std::vector<std::string> command = hidden;
        for (const std::string& word : tumble_command(arguments)) command.push_back(word);
        return run(command);
    };
    std::vector<std::string> trial = hidden;
    trial.emplace_back("true");
    if (run(trial).code != 0) {
        MESSAGE("left out: this process may not hide the fonts");
        return;
    }
    const Folder folder;
    const Answer doctor = answer({"doctor", "--json"});
    CHECK(doctor.code == 5);
    const json report = json::parse(doctor.out);
    CHECK(report["text"] == false);
    CHECK(report["frames"] == true);
    CHECK(report["fonts"][0]["package"] == "fonts-dejavu-core");
    const Answer text = answer(shot((folder / "a.png").string()));
    CHECK(text.code == 5);
    CHECK(has(text, "fonts-dejavu-core"));
    CHECK(answer(shot((folder / "bare.png").string(), {"--hide", "title,time,scale"})).code == 0);
    const std::string scene = kPendulum;
    CHECK(answer({"shot", scene, "-o", (folder / "small.png").string(), "--size", "320x180"}).code == 0);
}

TEST_CASE("without a folder for temporary files, the doctor reports all else") {
    Machine machine;
    machine.hide_temporary_folder();
    const json report = machine.doctor(5);
    CHECK(report["frames"] == true);
    CHECK(report["videos"] == false);
    for (const json& encoder : report["encoders"]) {
        CHECK(encoder["detail"].get<std::string>().find("TMPDIR") != std::string::npos);
        CHECK(encoder["package"] == "");
    }
}
