#include "core/exr_file.h"

#include <gtest/gtest.h>

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>

#include "core/error.h"

namespace rays {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for every test, gone afterwards.
class FilmFile : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_ = fs::temp_directory_path() / ("film-" + std::to_string(::getpid()));
};

Film numbered_film() {
    Film film({7, 5});
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) film.at(x, y) = Radiance(float(x), float(y) / 3, 1e6f * float(x * y), 9);
    return film;
}

TEST_F(FilmFile, ExrKeepsEveryFloat) {
    const Film film = numbered_film();
    const auto path = (folder_ / "picture.exr").string();
    write_exr(film, path);

    Imf::InputFile file(path.c_str());
    const auto window = file.header().dataWindow();
    ASSERT_EQ(window.max.x - window.min.x + 1, 7);
    ASSERT_EQ(window.max.y - window.min.y + 1, 5);
    ASSERT_EQ(file.header().channels().findChannel("R")->type, Imf::FLOAT);
    std::vector<float> blue(7 * 5);
    Imf::FrameBuffer frame;
    frame.insert("B", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(blue.data()), sizeof(float), 7 * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(0, 4);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) EXPECT_EQ(blue[std::size_t(y * 7 + x)], film.at(x, y)[2]);
}

TEST_F(FilmFile, AFailedWriteLeavesNothingAndSaysWhere) {
    const auto path = (folder_ / "no such folder" / "picture.exr").string();
    try {
        write_exr(numbered_film(), path);
        FAIL() << "wrote into a folder that is not there";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find(path), std::string::npos) << e.what();
    }
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(FilmFile, AFailedWriteKeepsTheOldPicture) {
    const auto path = folder_ / "picture.exr";
    write_exr(numbered_film(), path.string());
    const auto size = fs::file_size(path);
    fs::create_directory(path.string() + ".partial");  // the name a new picture would be written under first
    EXPECT_THROW(write_exr(Film({300, 300}), path.string()), InputError);
    EXPECT_EQ(fs::file_size(path), size);
}

// ---- Films in large pages, files in large pieces --------------------------------------------------------------------

/// 3 MiB and a bit in memory, more than one page of 2 MiB; in the file, pieces of 256 KiB and a rest.
Film large_film() {
    Film film({449, 439});
    for (int y = 0; y < 439; ++y)
        for (int x = 0; x < 449; ++x) film.at(x, y) = Radiance(float(x), float(y), float(x * y) / 7);
    return film;
}

/// The channels R, G, B of a file, pixel by pixel.
std::vector<float> channels_of(const fs::path& path, int width, int height) {
    Imf::InputFile file(path.c_str());
    std::vector<float> values(std::size_t(width) * std::size_t(height) * 3);
    Imf::FrameBuffer frame;
    const char* const names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c)
        frame.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data() + c), 3 * sizeof(float),
                                          std::size_t(width) * 3 * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(0, height - 1);
    return values;
}

TEST(LargeFilm, BeginsBlackOnItsOwnPagesAndIsCopiedAndMovedAsOthersAre) {
    Film film({449, 439});
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&film.at(0, 0)) % (2 << 20), 0u)
        << "large pages begin at multiples of 2 MiB";
    for (int y = 0; y < 439; ++y)
        for (int x = 0; x < 449; ++x) ASSERT_TRUE(film.at(x, y).is_black());
    film = large_film();
    Film copy = film;
    EXPECT_NE(&copy.at(0, 0), &film.at(0, 0));
    EXPECT_EQ(copy.at(448, 438)[2], 448.0f * 438 / 7);
    const Radiance* const place = &copy.at(0, 0);
    const Film moved = std::move(copy);
    EXPECT_EQ(&moved.at(0, 0), place);
    EXPECT_EQ(film.at(448, 438)[0], 448);
}

TEST(LargeFilm, SizesAroundAPageWork) {
    // One pixel less than 2 MiB, 2 MiB exactly, one more.
    for (const int width : {(1 << 17) - 1, 1 << 17, (1 << 17) + 1}) {
        Film film({width, 1});
        film.at(width - 1, 0) = Radiance(1.0f);
        EXPECT_EQ(film.at(width - 1, 0)[0], 1);
        EXPECT_TRUE(film.at(width - 2, 0).is_black());
    }
}

TEST(LargeFilm, TooLargeIsAnErrorNotACrash) {
    LargePages<Radiance> pages;
    EXPECT_THROW(static_cast<void>(pages.allocate(~std::size_t(0) / sizeof(Radiance))), std::bad_alloc);
    EXPECT_THROW(static_cast<void>(pages.allocate(~std::size_t(0))), std::bad_alloc);
}

TEST_F(FilmFile, LargePicturesKeepEveryFloat) {
    const auto path = folder_ / "large.exr";
    write_exr(large_film(), path.string());
    const std::vector<float> read = channels_of(path, 449, 439);
    const Film film = large_film();
    for (int y = 0; y < 439; ++y)
        for (int x = 0; x < 449; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(read[(std::size_t(y) * 449 + std::size_t(x)) * 3 + std::size_t(c)], film.at(x, y)[c]);
}

/// Some lines of a film, from `first` on.
Film lines_of(const Film& film, int first, int count) {
    Film lines({film.raster().width, count});
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < film.raster().width; ++x) lines.at(x, y) = film.at(x, first + y);
    return lines;
}

TEST_F(FilmFile, LinesMayComeInAnyOrderFromAnyThread) {
    const Film film = large_film();
    const auto whole = (folder_ / "whole.exr").string(), piecewise = (folder_ / "piecewise.exr").string();
    write_exr(film, whole);
    ExrFile file(piecewise, film.raster());
    const auto send = [&](int from) {  // every second piece of seven lines, the last one first
        for (int y = from; y >= 0; y -= 14) file.take(lines_of(film, y, std::min(7, film.raster().height - y)), y);
    };
    std::thread other([&] { send(434); });
    send(427);
    other.join();
    EXPECT_FALSE(fs::exists(piecewise)) << "it appears when it is whole";
    file.finish();
    const auto bytes = [](const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    EXPECT_EQ(bytes(piecewise), bytes(whole));
    EXPECT_FALSE(fs::exists(piecewise + ".partial"));
}

TEST_F(FilmFile, WhatIsNotFinishedLeavesNothingAndKeepsTheOldPicture) {
    const auto path = (folder_ / "picture.exr").string();
    write_exr(numbered_film(), path);
    const auto size = fs::file_size(path);
    {
        ExrFile file(path, {449, 439});
        file.take(lines_of(large_film(), 0, 5), 0);
    }
    EXPECT_EQ(fs::file_size(path), size);
    EXPECT_FALSE(fs::exists(path + ".partial"));
}

/// A disk without room, for the name under which a picture is written first.
class FullDisk : public FilmFile {
protected:
    void SetUp() override {
        FilmFile::SetUp();
        if (::access("/dev/full", W_OK) != 0) GTEST_SKIP() << "there is no /dev/full";
        write_exr(numbered_film(), path_.string());
        size_ = fs::file_size(path_);
        fs::create_symlink("/dev/full", path_.string() + ".partial");
    }
    void expect_error(const Film& film) {
        try {
            write_exr(film, path_.string());
            FAIL() << "wrote where there is no room";
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find("No space left on device"), std::string::npos) << e.what();
            EXPECT_NE(std::string(e.what()).find("has room"), std::string::npos) << e.what();
        }
        EXPECT_FALSE(fs::exists(fs::symlink_status(path_.string() + ".partial"))) << "a half picture is left";
        EXPECT_EQ(fs::file_size(path_), size_) << "the old picture is gone";
    }
    fs::path path_ = folder_ / "picture.exr";
    std::uintmax_t size_ = 0;
};

TEST_F(FullDisk, IsAnErrorWhenASmallPictureIsClosed) { expect_error(numbered_film()); }
TEST_F(FullDisk, IsAnErrorInTheMiddleOfALargePicture) { expect_error(large_film()); }

TEST_F(FilmFile, ADiskThatFillsUpLaterIsAnErrorToo) {
    // The first piece is written, then files may grow no more.
    const auto path = folder_ / "large.exr";
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
    const rlimit small{300 << 10, limit.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    EXPECT_THROW(write_exr(large_film(), path.string()), InputError);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    std::signal(SIGXFSZ, before);
    EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace rays
