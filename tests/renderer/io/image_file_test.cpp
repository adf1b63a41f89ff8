#include "renderer/io/image_file.h"

#include <gmock/gmock.h>

#include "renderer/error.h"
#include "tests/renderer/io/io_test_files.h"
#include "tests/renderer/io/sample_files.h"

namespace guidelight::test {
namespace {

using ::testing::HasSubstr;

Image ramp(int width, int height, int channels, float scale) {
  Image image(width, height, channels);
  for (size_t i = 0; i < image.data().size(); ++i) image.data()[i] = static_cast<float>(i) * scale;
  return image;
}

std::string image_error(const std::string& bytes) {
  try {
    read_image(bytes.data(), bytes.size(), "picture");
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(ExrFile, FloatLayersAndMetadataSurvive) {
  const TemporaryFolder folder;
  ImageLayers written;
  written.layers.emplace_back("beauty", ramp(5, 3, 3, 0.37f));
  written.layers.emplace_back("normal", ramp(5, 3, 3, -0.11f));
  written.layers.emplace_back("depth", ramp(5, 3, 1, 1e6f));
  written.metadata = {{"scene", "box.xml"}, {"settings", "{\"depth\": 5, \"ü\": \"µ\"}"}};
  write_exr(folder / "a.exr", written, false);
  const ImageLayers read = read_exr(folder / "a.exr");
  ASSERT_EQ(read.layers.size(), 3u);
  EXPECT_EQ(read.layers[0].first, "beauty");
  for (const auto& [name, image] : written.layers) {
    const auto found = std::find_if(read.layers.begin(), read.layers.end(),
                                    [&, n = name](const auto& layer) { return layer.first == n; });
    ASSERT_NE(found, read.layers.end()) << name;
    EXPECT_EQ(found->second.channels(), image.channels());
    EXPECT_TRUE(std::equal(image.data().begin(), image.data().end(), found->second.data().begin()));
  }
  for (const auto& [key, value] : written.metadata) EXPECT_EQ(read.metadata.at(key), value);
  EXPECT_EQ(read_metadata(folder / "a.exr").at("settings"), written.metadata.at("settings"));
}

TEST(ExrFile, HalfKeepsElevenBitsAndNeverTurnsInfinite) {
  const TemporaryFolder folder;
  ImageLayers written{{{"beauty", ramp(16, 16, 3, 0.731f)}, {"depth", ramp(16, 16, 1, 1e6f)}}, {}};
  written.layers[0].second.data()[0] = 1e9f;
  write_exr(folder / "a.exr", written, true);
  const ImageLayers read = read_exr(folder / "a.exr");
  EXPECT_EQ(read.layers[0].second.data()[0], 65504.0f);
  for (size_t i = 1; i < 16 * 16 * 3; ++i) {
    const float expected = written.layers[0].second.data()[i];
    EXPECT_NEAR(read.layers[0].second.data()[i], expected, expected / 2048);
  }
  // Depth is a float all the same.
  EXPECT_EQ(read.layers[1].second.data()[200], written.layers[1].second.data()[200]);
}

TEST(ExrFile, LayersOfDifferentSizeAreRefused) {
  const TemporaryFolder folder;
  const ImageLayers picture{{{"beauty", Image(4, 4, 3)}, {"depth", Image(4, 5, 1)}}, {}};
  EXPECT_THROW(write_exr(folder / "a.exr", picture), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
}

TEST(PngFile, PixelsAndMetadataSurvive) {
  const TemporaryFolder folder;
  DisplayImage image{3, 2, {}};
  for (int i = 0; i < 24; ++i) image.rgba.push_back(static_cast<uint8_t>(i * 10));
  const Metadata metadata = {{"scene", "a b.xml"}, {"unicode", "β = 10°"}, {"empty", ""}};
  write_png(folder / "a.png", image, metadata);
  EXPECT_EQ(read_metadata(folder / "a.png"), metadata);
  const Image read = read_image(folder / "a.png", ColorSpace::Linear);
  ASSERT_EQ(read.channels(), 4);
  for (size_t i = 0; i < image.rgba.size(); ++i) {
    EXPECT_FLOAT_EQ(read.data()[i], static_cast<float>(image.rgba[i]) / 255);
  }
}

TEST(PngFile, IsDecodedAsSrgbUnlessToldOtherwise) {
  const TemporaryFolder folder;
  write_png(folder / "a.png", DisplayImage{1, 1, {188, 10, 255, 128}});
  const Image srgb = read_image(folder / "a.png");
  // IEC 61966-2-1: ((188/255 + 0.055) / 1.055)^2.4 and (10/255) / 12.92.
  EXPECT_NEAR(srgb.data()[0], 0.502886f, 1e-5f);
  EXPECT_NEAR(srgb.data()[1], 0.0030353f, 1e-6f);
  EXPECT_FLOAT_EQ(srgb.data()[3], 128.0f / 255) << "alpha is never encoded";
  EXPECT_FLOAT_EQ(read_image(folder / "a.png", ColorSpace::Linear).data()[0], 188.0f / 255);
}

TEST(ImageFile, EveryFormatIsToldByItsContent) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_image(folder.write("a.xyz", sample_png())).width(), 4);
  EXPECT_EQ(read_image(folder.write("b.xyz", sample_jpeg())).width(), 16);
  EXPECT_EQ(read_image(folder.write("c.PNG", sample_hdr())).height(), 8);
  EXPECT_EQ(read_image(folder.write("d", sample_bmp())).width(), 4);
  EXPECT_EQ(read_image(folder.write("e", sample_tga())).width(), 4);
  EXPECT_EQ(read_image(folder.write("f", sample_exr())).width(), 8);
  EXPECT_FLOAT_EQ(read_image(folder / "c.PNG").data()[1], 3.5f);
}

TEST(ImageFile, TruncatedImagesAreErrors) {
  for (const std::string& bytes :
       {sample_png(), sample_jpeg(), sample_hdr(), sample_bmp(), sample_tga(), sample_exr()}) {
    ASSERT_EQ(image_error(bytes), "");
    for (const double share : {0.1, 0.5, 0.9}) {
      const std::string cut = bytes.substr(0, static_cast<size_t>(bytes.size() * share));
      EXPECT_THAT(image_error(cut), HasSubstr("picture")) << bytes.substr(0, 4) << share;
    }
  }
}

TEST(ImageFile, AbsurdSizesAreErrorsBeforeMemoryIsTaken) {
  std::string png = sample_png();
  for (const size_t i : {16, 17, 20, 21}) png[i] = '\x7f';  // width and height in the header
  EXPECT_NE(image_error(png), "");
  std::string hdr = sample_hdr();
  hdr.replace(hdr.find("-Y 8 +X 16"), 10, "-Y 60000 +X 60000");
  EXPECT_THAT(image_error(hdr), HasSubstr("60000"));
  std::string bmp = sample_bmp();
  bmp[20] = bmp[24] = '\x40';  // high bytes of width and height
  EXPECT_NE(image_error(bmp), "");
}

TEST(ImageFile, MissingEmptyAndUnknownFilesAreErrors) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_image(folder / "missing.png"), Error);
  EXPECT_THROW(read_image(folder.path().string()), Error);
  EXPECT_NE(image_error(""), "");
  EXPECT_NE(image_error("GIF89a and so on"), "");
  EXPECT_NE(image_error("just some words that are no image"), "");
  EXPECT_THROW(read_metadata(folder.write("a.bmp", sample_bmp())), Error);
}

}  // namespace
}  // namespace guidelight::test
