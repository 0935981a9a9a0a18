#include "render/grey_png.hpp"

#include "core/error.hpp"
#include "render/temporary_folder.hpp"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

namespace eisph {
namespace {

using testing::HasSubstr;

constexpr std::array<double, 3> kWeights = {0.25, 0.5, 0.25};

GreyPicture ramp() {
  GreyPicture picture(37, 11);
  for (std::size_t k = 0; k < picture.level.size(); ++k)
    picture.level[k] = static_cast<float>(k) / static_cast<float>(picture.level.size() - 1);
  return picture;
}

std::string refusal(const std::filesystem::path& path) {
  try {
    (void)read_grey_png(path, kWeights);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(GreyPng, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  for (const int bits : {8, 16}) {
    const double white = bits == 8 ? 255.0 : 65535.0;
    write_grey_png(folder.path() / "grey.png", ramp(), bits, {{"Title", "ramp"}});
    const GreyPng read = read_grey_png(folder.path() / "grey.png", kWeights);
    EXPECT_EQ(read.bit_depth, bits);
    EXPECT_FALSE(read.coloured);
    ASSERT_EQ(read.picture.width, 37);
    ASSERT_EQ(read.picture.height, 11);
    const GreyPicture expected = ramp();
    for (std::size_t k = 0; k < expected.level.size(); ++k) {
      EXPECT_EQ(std::lround(white * read.picture.level[k]), std::lround(white * expected.level[k]));
      EXPECT_NEAR(white * read.picture.level[k], std::round(white * read.picture.level[k]), 0.01);
    }
  }
}

TEST(GreyPng, WeighsColours) {
  const TemporaryFolder folder;
  Image image(2, 1);
  image.pixel(0, 0)[0] = 255;
  image.pixel(0, 0)[1] = 51;
  image.pixel(1, 0)[2] = 102;
  write_png(folder.path() / "colour.png", image, {});
  const GreyPng read = read_grey_png(folder.path() / "colour.png", kWeights);
  EXPECT_TRUE(read.coloured);
  EXPECT_FLOAT_EQ(read.picture.at(0, 0), 0.25F + 0.5F * 0.2F);
  EXPECT_FLOAT_EQ(read.picture.at(1, 0), 0.25F * 0.4F);
}

TEST(GreyPng, NamesTheFileThatIsNoSuchPicture) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.path() / "none.png"), HasSubstr("none.png: cannot be read"));
  std::ofstream(folder.path() / "text.png") << "no picture";
  EXPECT_THAT(refusal(folder.path() / "text.png"), HasSubstr("text.png: not a PNG file"));
  write_grey_png(folder.path() / "cut.png", ramp(), 16, {});
  std::filesystem::resize_file(folder.path() / "cut.png", 300);
  EXPECT_THAT(refusal(folder.path() / "cut.png"), HasSubstr("cut.png: damaged"));
}

TEST(GreyPng, RefusesOneBitAndPalettes) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, int bits, int type) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    std::FILE* file = std::fopen((folder.path() / name).c_str(), "wb");
    png_init_io(png, file);
    png_set_IHDR(png, info, 8, 1, bits, type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    const png_color black = {0, 0, 0};
    if (type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, &black, 1);
    png_write_info(png, info);
    const png_byte row[8] = {};
    png_write_row(png, row);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
  };
  write("bits.png", 1, PNG_COLOR_TYPE_GRAY);
  EXPECT_THAT(refusal(folder.path() / "bits.png"), HasSubstr("a PNG of 1 bits; expected"));
  write("palette.png", 8, PNG_COLOR_TYPE_PALETTE);
  EXPECT_THAT(refusal(folder.path() / "palette.png"), HasSubstr("with a palette"));
}

}  // namespace
}  // namespace eisph
