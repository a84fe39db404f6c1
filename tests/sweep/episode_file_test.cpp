// The episodes of a Minari dataset: the groups, data sets and attributes that Minari 0.5 reads.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "support/near.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/hdf5/episode_file.hpp"
#include "sweep/hdf5_contents.hpp"
#include "tumble/file.hpp"

namespace fs = std::filesystem;
using namespace tumble::sweep;
using tumble::TemporaryFolder;
using tumble::test::Hdf5Contents;
using tumble::test::near;

namespace {

// Four states of one body, and two states of two.
std::vector<Episode> two_episodes() {
    std::vector<double> numbers(24);
    for (std::size_t i = 0; i < 24; ++i) numbers[i] = 0.5 * static_cast<double>(i);
    Episode first{.run = 3, .seed = 77, .states = {4, 1, numbers}, .action = {1.5, -2.0}, .reward = -6.0};
    first.attributes = {{"options/speed", 1.5}, {"options/shape", std::string("b\xc3\xb6x, \"3\"")}};
    Episode second{.run = 5,
                   .seed = 0xffffffffffffffff,
                   .states = {2, 2, numbers},
                   .is_terminated = true,
                   .action = {0.0, 4.0},
                   .reward = 2.0};
    return {first, second};
}

void write(const fs::path& file, const std::vector<Episode>& episodes) {
    EpisodeFileWriter writer(file, 2, 32);
    for (const Episode& episode : episodes) writer.append(episode);
    const std::uint64_t bytes = writer.commit();
    CHECK(bytes == fs::file_size(file));
}

}  // namespace

TEST_CASE("an episode has one observation more than steps, an action for each step, and ends with its last step") {
    const TemporaryFolder folder;
    write(folder.path / "main_data.hdf5", two_episodes());
    const Hdf5Contents file(folder.path / "main_data.hdf5");
    CHECK(file.sizes("episode_0/observations") == std::vector<hsize_t>{4, 12});
    CHECK(file.type("episode_0/observations") == "float 4");
    const std::vector<double> seen = file.numbers("episode_0/observations");
    CHECK(seen[5] == 2.5);
    CHECK(std::isnan(seen[6]));  // its second body
    CHECK(seen[12] == 3.0);
    CHECK(file.sizes("episode_1/observations") == std::vector<hsize_t>{2, 12});
    CHECK(file.numbers("episode_1/observations")[23] == 11.5);
    CHECK(file.sizes("episode_0/actions") == std::vector<hsize_t>{3, 2});
    CHECK(file.numbers("episode_0/actions") == std::vector<double>{1.5, -2.0, 1.5, -2.0, 1.5, -2.0});
    CHECK(file.type("episode_0/actions") == "float 8");
    CHECK(file.numbers("episode_0/rewards") == std::vector<double>{0.0, 0.0, -6.0});
    CHECK(file.type("episode_0/rewards") == "float 8");
    CHECK(file.numbers("episode_0/terminations") == std::vector<double>{0, 0, 0});
    CHECK(file.numbers("episode_0/truncations") == std::vector<double>{0, 0, 1});
    CHECK(file.numbers("episode_1/terminations") == std::vector<double>{1});
    CHECK(file.numbers("episode_1/truncations") == std::vector<double>{0});
    CHECK(file.type("episode_0/terminations") == "truth");
    CHECK(file.type("episode_0/truncations") == "truth");
    CHECK(file.has("episode_1/infos"));
    CHECK_FALSE(file.has("episode_2"));
}

TEST_CASE("an episode has the attributes of Minari, its run, and what it was made from") {
    const TemporaryFolder folder;
    write(folder.path / "main_data.hdf5", two_episodes());
    const Hdf5Contents file(folder.path / "main_data.hdf5");
    const auto attribute = [&](const char* name) { return file.attribute("episode_0", name); };
    CHECK(attribute("id") == 0);
    CHECK(file.attribute("episode_1", "id") == 1);
    CHECK(attribute("run") == 3);
    CHECK(attribute("seed") == 77);
    CHECK(file.attribute("episode_1", "seed") == 18446744073709551615.0);
    CHECK(attribute("total_steps") == 3);
    // Of 0, 0 and -6: the mean of the squares is 12, less 4 gives 8.
    CHECK(attribute("rewards_sum") == -6.0);
    CHECK(attribute("rewards_mean") == -2.0);
    CHECK(near(attribute("rewards_std"), std::sqrt(8.0), tumble::test::kDouble));
    CHECK(attribute("rewards_max") == 0.0);
    CHECK(attribute("rewards_min") == -6.0);
    // A single step.
    CHECK(file.attribute("episode_1", "rewards_std") == 0.0);
    CHECK(file.attribute("episode_1", "rewards_min") == 2.0);
    CHECK(attribute("options/speed") == 1.5);
    CHECK(file.text_attribute("episode_0", "options/shape") == "b\xc3\xb6x, \"3\"");
}

TEST_CASE("the same episodes give the same bytes") {
    const TemporaryFolder folder;
    write(folder.path / "a", two_episodes());
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 counts times in seconds
    write(folder.path / "b", two_episodes());
    CHECK(tumble::read_file(folder.path / "a") == tumble::read_file(folder.path / "b"));
}

TEST_CASE("an episode without actions has rows of none") {
    const TemporaryFolder folder;
    std::vector<Episode> episodes = two_episodes();
    episodes[0].action.clear();
    episodes.resize(1);
    write(folder.path / "a", episodes);
    CHECK(Hdf5Contents(folder.path / "a").sizes("episode_0/actions") == std::vector<hsize_t>{3, 0});
}
