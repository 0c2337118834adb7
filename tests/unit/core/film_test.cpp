#include "core/film.h"

#include <gtest/gtest.h>

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <unistd.h>

#include <filesystem>

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

}  // namespace
}  // namespace rays
