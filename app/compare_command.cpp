#include <fmt/core.h>

#include "app/commands.h"
#include "app/scene_arguments.h"
#include "renderer/error.h"
#include "renderer/image/metrics.h"
#include "renderer/image/pixel_region.h"
#include "renderer/image/tonemap.h"
#include "renderer/io/atomic_file.h"
#include "renderer/io/image_file.h"
#include "renderer/io/metrics_json.h"

namespace guidelight {

namespace {

struct CompareCommand {
  std::string image;
  std::string reference;
  std::string error_map;
  std::string crop;
  bool json = false;

  void run() const;

 private:
  Image read(const std::string& path) const;
};

void print_measure(const char* name, const ErrorMeasure& measure) {
  fmt::print("{:<22} {:<12.6g} {:.6g}\n", name, measure.plain, measure.robust);
}

void print_table(const ImageMetrics& m) {
  fmt::print("{:<22} {:<12} without the worst 0.1 %\n", "", "plain");
  print_measure("RMS relative error", m.rms_relative_error);
  print_measure("relMSE", m.relative_mse);
  print_measure("mean absolute error", m.mean_absolute_error);
  fmt::print("{:<22} {:.6g} against {:.6g} ({:+.3f} %)\n", "mean luminance", m.mean,
             m.reference_mean, 100 * m.relative_bias);
  fmt::print("{:<22} rms {:.3f} %, largest {:+.3f} %\n", "bias of 16x16 blocks",
             100 * m.rms_block_bias, 100 * m.largest_block_bias);
  fmt::print("{:<22} {}, of them {} not finite, {} black in the reference\n", "pixels", m.pixels,
             m.not_finite, m.black_reference);
}

/// A picture, or the part of it that --crop names.
Image CompareCommand::read(const std::string& path) const {
  Image picture = read_image(path, ColorSpace::Linear);
  if (crop.empty()) return picture;
  return cropped(picture, parse_region("--crop", crop, picture.width(), picture.height()));
}

void CompareCommand::run() const {
  if (!error_map.empty()) check_writable(error_map);
  const Image a = read(image);
  const Image b = read(reference);
  const ImageMetrics metrics = compare_images(a, b);
  if (json) {
    fmt::print("{}\n", metrics_json(metrics));
  } else {
    print_table(metrics);
  }
  if (!error_map.empty()) {
    DisplaySettings display;
    display.curve = ToneCurve::FalseColor;
    display.false_color_min = 1e-4f;
    display.false_color_max = 1e1f;
    DisplayImage picture;
    display_image(relative_error_map(a, b), display, picture);
    write_png(error_map, picture);
  }
}

}  // namespace

void add_compare_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("compare", "Measure how far a picture is from a reference");
  const auto arguments = std::make_shared<CompareCommand>();
  command->add_option("IMAGE", arguments->image, "Picture to judge")->required();
  command->add_option("REFERENCE", arguments->reference, "Picture to judge by, same size")
      ->required();
  command
      ->add_option("--error-map", arguments->error_map,
                   "Write relMSE per pixel as a false-colour .png, 1e-4 to 10")
      ->check(ends_in(".png"));
  command->add_option("--crop", arguments->crop, "Judge only x0,y0,x1,y1 [pixels]");
  command->add_flag("--json", arguments->json, "Print one line of JSON");
  command->callback([arguments] { arguments->run(); });
}

}  // namespace guidelight
