#include "sweep/hdf5/episode_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sweep/hdf5/hdf5_output.hpp"
#include "sweep/store/durable.hpp"

namespace tumble::sweep {

namespace {

// The states as rows of the same length, filled up by NaN.
std::vector<double> rows_of(const TrajectoryArray& states, std::size_t bodies) {
    const std::size_t used = states.bodies * kStateNumbers, row = bodies * kStateNumbers;
    std::vector<double> rows(states.steps * row, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t step = 0; step < states.steps; ++step)
        std::copy_n(states.numbers.data() + step * used, used, rows.data() + step * row);
    return rows;
}

}  // namespace

struct EpisodeFileWriter::Impl {
    Impl(const std::filesystem::path& path, std::size_t bodies_, int bits)
        : file(path), bodies(bodies_), stored(bits == 64 ? H5T_IEEE_F64LE : H5T_IEEE_F32LE) {
        truth = file.required(Handle(H5Tenum_create(H5T_STD_I8LE), H5Tclose));
        for (const std::int8_t value : {std::int8_t{0}, std::int8_t{1}})
            file.required(H5Tenum_insert(truth, value == 0 ? "FALSE" : "TRUE", &value));
        text = file.required(Handle(H5Tcopy(H5T_C_S1), H5Tclose));
        file.required(H5Tset_size(text, H5T_VARIABLE));
        file.required(H5Tset_cset(text, H5T_CSET_UTF8));
    }

    void append(const Episode& episode);
    void write_attribute(hid_t group, const std::string& name, hid_t stored_as, hid_t given, const void* value) const;
    void write_number(hid_t group, const std::string& name, std::uint64_t number) const;
    void write_number(hid_t group, const std::string& name, double number) const;
    void write_text(hid_t group, const std::string& name, const std::string& value) const;
    void write_steps(hid_t group, const Episode& episode) const;
    void write_rewards(hid_t group, double reward, std::size_t steps) const;

    Hdf5Output file;
    std::size_t bodies;
    hid_t stored;
    Handle truth{}, text{};  // types: a truth value as h5py stores it, and a text
    std::uint64_t episodes = 0;
};

void EpisodeFileWriter::Impl::write_attribute(hid_t group, const std::string& name, hid_t stored_as, hid_t given,
                                              const void* value) const {
    const Handle space = file.required(Handle(H5Screate(H5S_SCALAR), H5Sclose));
    const Handle attribute =
        file.required(Handle(H5Acreate2(group, name.c_str(), stored_as, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose));
    file.required(H5Awrite(attribute, given, value));
}

void EpisodeFileWriter::Impl::write_number(hid_t group, const std::string& name, std::uint64_t number) const {
    // As a signed number, as Minari does, unless it is too large.
    const bool is_large = number > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    write_attribute(group, name, is_large ? H5T_STD_U64LE : H5T_STD_I64LE, H5T_NATIVE_UINT64, &number);
}

void EpisodeFileWriter::Impl::write_number(hid_t group, const std::string& name, double number) const {
    write_attribute(group, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &number);
}

void EpisodeFileWriter::Impl::write_text(hid_t group, const std::string& name, const std::string& value) const {
    const char* const pointer = value.c_str();
    write_attribute(group, name, text, text, &pointer);
}

// What a step leads to: actions, rewards, and whether the episode ends.
void EpisodeFileWriter::Impl::write_steps(hid_t group, const Episode& episode) const {
    const std::size_t steps = episode.states.steps - 1;
    std::vector<double> actions;
    for (std::size_t step = 0; step < steps; ++step)
        actions.insert(actions.end(), episode.action.begin(), episode.action.end());
    const std::array<hsize_t, 2> table{steps, episode.action.size()};
    const std::array<hsize_t, 1> column{steps};
    file.write(group, "actions", table, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, actions.data());
    std::vector<double> rewards(steps, 0.0);
    rewards.back() = episode.reward;
    file.write(group, "rewards", column, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, rewards.data());
    std::vector<std::int8_t> ends(steps, 0);
    ends.back() = episode.is_terminated ? 1 : 0;
    file.write(group, "terminations", column, truth, truth, ends.data());
    ends.back() = episode.is_terminated ? 0 : 1;
    file.write(group, "truncations", column, truth, truth, ends.data());
}

// Of `reward` and steps - 1 times 0.
void EpisodeFileWriter::Impl::write_rewards(hid_t group, double reward, std::size_t steps) const {
    const auto count = static_cast<double>(steps);
    const double other = steps == 1 ? reward : 0.0;
    write_number(group, "rewards_sum", reward);
    write_number(group, "rewards_mean", reward / count);
    write_number(group, "rewards_std", std::abs(reward) * std::sqrt(count - 1.0) / count);
    write_number(group, "rewards_max", std::max(reward, other));
    write_number(group, "rewards_min", std::min(reward, other));
}

void EpisodeFileWriter::Impl::append(const Episode& episode) {
    const std::string name = "episode_" + std::to_string(episodes);
    const Handle group =
        file.required(Handle(H5Gcreate2(file.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose));
    file.required(Handle(H5Gcreate2(group, "infos", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose));
    const TrajectoryArray& states = episode.states;
    const std::vector<double> rows = rows_of(states, bodies);
    const std::array<hsize_t, 2> sizes{states.steps, bodies * kStateNumbers};
    file.write(group, "observations", sizes, stored, H5T_NATIVE_DOUBLE, rows.data());
    write_steps(group, episode);
    write_number(group, "id", episodes);
    write_number(group, "seed", episode.seed);
    write_number(group, "total_steps", states.steps - 1);
    write_rewards(group, episode.reward, states.steps - 1);
    write_number(group, "run", episode.run);
    for (const auto& [key, value] : episode.attributes) {
        if (const double* const number = std::get_if<double>(&value))
            write_number(group, key, *number);
        else
            write_text(group, key, std::get<std::string>(value));
    }
    ++episodes;
}

EpisodeFileWriter::EpisodeFileWriter(const std::filesystem::path& file, std::size_t bodies, int bits) {
    const Hdf5Lock lock;
    impl_ = std::make_unique<Impl>(file, bodies, bits);
}

EpisodeFileWriter::~EpisodeFileWriter() {
    const Hdf5Lock lock;
    impl_.reset();
}

void EpisodeFileWriter::append(const Episode& episode) {
    const Hdf5Lock lock;
    impl_->append(episode);
}

void EpisodeFileWriter::save() {
    const Hdf5Lock lock;
    if (impl_->file.id() < 0) return;
    impl_->file.close();
    make_durable(impl_->file.temporary());
}

std::uint64_t EpisodeFileWriter::commit() {
    save();
    const Hdf5Lock lock;
    return impl_->file.commit();
}

}  // namespace tumble::sweep
