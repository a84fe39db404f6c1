// What is in an HDF5 file, read by the functions of HDF5.
#pragma once

#include <doctest/doctest.h>
#include <hdf5.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::test {

// An opened file. A path that does not exist in it fails the test.
class Hdf5Contents {
public:
    explicit Hdf5Contents(const std::filesystem::path& file)
        : file_(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
        REQUIRE(file_ >= 0);
    }
    ~Hdf5Contents() { H5Fclose(file_); }
    Hdf5Contents(const Hdf5Contents&) = delete;
    Hdf5Contents& operator=(const Hdf5Contents&) = delete;

    bool has(const std::string& path) const { return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0; }

    std::vector<hsize_t> sizes(const std::string& data) const {
        const hid_t set = open(data), space = H5Dget_space(set);
        std::vector<hsize_t> sizes(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
        H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
        H5Sclose(space);
        H5Dclose(set);
        return sizes;
    }

    // All numbers of a data set, as double; of truth values 0 and 1.
    std::vector<double> numbers(const std::string& data) const {
        const hid_t set = open(data), type = H5Dget_type(set);
        hsize_t count = 1;
        for (const hsize_t size : sizes(data)) count *= size;
        std::vector<double> numbers(count);
        if (H5Tget_class(type) == H5T_ENUM) {
            std::vector<signed char> truths(count);
            H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, truths.data());
            numbers.assign(truths.begin(), truths.end());
        } else {
            CHECK(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) >= 0);
        }
        H5Tclose(type);
        H5Dclose(set);
        return numbers;
    }

    // "float 4", "integer 8", "truth": the kind of the numbers of a data set, and their bytes.
    std::string type(const std::string& data) const {
        const hid_t set = open(data), type = H5Dget_type(set);
        std::string text =
            (H5Tget_class(type) == H5T_FLOAT ? "float " : "integer ") + std::to_string(H5Tget_size(type));
        if (H5Tget_class(type) == H5T_ENUM) {
            // As h5py stores numpy's bool.
            char name[8] = {};
            const signed char truth = 1;
            H5Tenum_nameof(type, &truth, name, sizeof name);
            text = std::string(name) == "TRUE" && H5Tget_size(type) == 1 ? "truth" : "other";
        }
        H5Tclose(type);
        H5Dclose(set);
        return text;
    }

    double attribute(const std::string& group, const std::string& name) const {
        double number = 0.0;
        const hid_t attribute = H5Aopen_by_name(file_, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
        REQUIRE_MESSAGE(attribute >= 0, name);
        CHECK(H5Aread(attribute, H5T_NATIVE_DOUBLE, &number) >= 0);
        H5Aclose(attribute);
        return number;
    }

    std::string text_attribute(const std::string& group, const std::string& name) const {
        char* text = nullptr;
        const hid_t attribute = H5Aopen_by_name(file_, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
        REQUIRE_MESSAGE(attribute >= 0, name);
        const hid_t type = H5Aget_type(attribute);
        CHECK(H5Aread(attribute, type, &text) >= 0);
        std::string copy = text == nullptr ? "" : text;
        H5free_memory(text);
        H5Tclose(type);
        H5Aclose(attribute);
        return copy;
    }

private:
    hid_t open(const std::string& data) const {
        const hid_t set = H5Dopen2(file_, data.c_str(), H5P_DEFAULT);
        REQUIRE_MESSAGE(set >= 0, data);
        return set;
    }

    hid_t file_;
};

}  // namespace tumble::test
