#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "renderer/error.h"
#include "renderer/io/guide_file.h"
#include "renderer/io/image_file.h"
#include "renderer/transport/guide_check.h"
#include "tests/renderer/io/io_test_files.h"
#include "tests/renderer/io/sample_files.h"
#include "tests/renderer/transport/guide_scenes.h"

/// Damaged files must end in a scene or in one Error: no crash, no hang, no gigabyte. Each is read
/// in a process of its own with limits on memory and time.
namespace guidelight::test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitMemory = false;  // sanitizers reserve terabytes of address space
#else
constexpr bool kLimitMemory = true;
#endif

constexpr int kMutationsPerFile = 60;
constexpr rlim_t kExtraMemory = rlim_t{1} << 30;
constexpr rlim_t kCpuSeconds = 10;

enum ExitCode { kGood = 0, kOtherException = 2, kOutOfMemory = 3 };

void limit_resources() {
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const rlimit cpu{kCpuSeconds, kCpuSeconds};
  ::setrlimit(RLIMIT_CPU, &cpu);
  ::alarm(3 * kCpuSeconds);  // waiting for ever needs no processor time
  if (!kLimitMemory) return;
  size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t bytes = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + kExtraMemory;
  const rlimit memory{bytes, bytes};
  ::setrlimit(RLIMIT_AS, &memory);
}

/// Runs `read` in a child; 0 for a result or an Error, else what went wrong.
template <typename Read>
int run_limited(const Read& read) {
  const pid_t child = ::fork();
  if (child == 0) {
    limit_resources();
    int code = kGood;
    try {
      read();
    } catch (const Error& error) {
      const std::string message = error.what();
      if (message.find("bad_alloc") != std::string::npos) code = kOutOfMemory;
    } catch (const std::bad_alloc&) {
      code = kOutOfMemory;
    } catch (...) {
      code = kOtherException;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

/// One of the ways in which files get damaged, or are made to do damage.
std::string mutate(std::string bytes, std::mt19937& random) {
  static const std::vector<std::string> kTokens = {
      "nan", "1e999", "-1", "4294967295", "99999999999999999999", "0", "", "-9223372036854775808",
      "$x",  "<",     "\""};
  const auto below = [&](size_t n) { return n == 0 ? 0 : random() % n; };
  switch (below(7)) {
    case 0:  // flipped bits
      for (size_t i = 0; i <= below(8); ++i)
        bytes[below(bytes.size())] ^= static_cast<char>(1 << below(8));
      break;
    case 1:  // cut off
      bytes.resize(below(bytes.size()));
      break;
    case 2: {  // a part twice
      const size_t at = below(bytes.size());
      bytes.insert(at, bytes.substr(at, below(64) + 1));
      break;
    }
    case 3:  // a part missing
      bytes.erase(below(bytes.size()), below(64) + 1);
      break;
    case 4: {  // extreme numbers in binary headers
      const size_t at = below(std::min<size_t>(bytes.size(), 128));
      const char value = static_cast<char>(std::array{0x00, 0xff, 0x7f, 0x80}[below(4)]);
      for (size_t i = at; i < std::min(bytes.size(), at + 4); ++i) bytes[i] = value;
      break;
    }
    case 5: {  // another number in text
      const size_t at = bytes.find_first_of("0123456789", below(bytes.size()));
      if (at == std::string::npos) break;
      const size_t end = std::min(bytes.find_first_not_of("0123456789.", at), bytes.size());
      bytes.replace(at, end - at, kTokens[below(kTokens.size())]);
      break;
    }
    default:  // noise
      for (size_t i = 0; i < 16; ++i) bytes[below(bytes.size())] = static_cast<char>(random());
  }
  return bytes;
}

struct FuzzCase {
  const char* name;
  std::string (*sample)();
  const char* file;    // what is damaged
  const char* opened;  // what is read then: a scene, or the damaged image itself
};

void PrintTo(const FuzzCase& c, std::ostream* out) { *out << c.name; }

const char* const kScene = R"(<scene version="3.0.0">
  <default name="alpha" value="0.2"/>
  <include filename="included.xml"/>
  <integrator type="path"><integer name="max_depth" value="5"/></integrator>
  <sensor type="perspective"><float name="fov" value="40"/>
    <transform name="to_world"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="32"/><integer name="height" value="16"/></film>
  </sensor>
  <bsdf type="twosided" id="a"><bsdf type="roughplastic"><float name="alpha" value="$alpha"/>
    <texture type="bitmap" name="diffuse_reflectance"><string name="filename" value="image"/></texture>
  </bsdf></bsdf>
  <shape type="obj"><string name="filename" value="mesh.obj"/><ref id="a"/></shape>
  <shape type="ply"><string name="filename" value="mesh.ply"/><ref id="b"/></shape>
  <shape type="serialized"><string name="filename" value="mesh.serialized"/>
    <integer name="shape_index" value="1"/></shape>
  <shape type="sphere"><emitter type="area">
    <spectrum name="radiance" value="400:1, 500:2, 700:3"/></emitter></shape>
  <emitter type="envmap"><string name="filename" value="image"/></emitter>
</scene>)";

std::string sample_scene() { return kScene; }
std::string sample_include() {
  return R"(<scene version="3.0.0"><bsdf type="dielectric" id="b"/><alias id="b" as="c"/></scene>)";
}
std::string sample_ply_little() { return sample_ply_binary(false); }
std::string sample_serialized_4() { return sample_serialized(4); }

/// Guides through a glass ball, and one that is switched off.
std::string sample_guides() {
  const guide_test::LitScene& lit = guide_test::lit_scenes()[0];
  auto guides = guide_test::guides_for(*lit.build(), lit);
  guides[0].name = "to the floor";
  guides[3].enabled = false;
  return guides_text(guides);
}

class Fuzz : public ::testing::TestWithParam<FuzzCase> {};

TEST_P(Fuzz, DamagedFilesEndInASceneOrAnError) {
  const FuzzCase& c = GetParam();
  const TemporaryFolder folder;
  folder.write("scene.xml", kScene);
  folder.write("included.xml", sample_include());
  folder.write("mesh.obj", sample_obj());
  folder.write("mesh.ply", sample_ply_text());
  folder.write("mesh.serialized", sample_serialized());
  folder.write("image", sample_png());
  const std::string original = c.sample();
  const std::string opened = folder / c.opened;
  const bool is_image = std::string(c.opened) == "image";
  const auto read = [&] {
    if (is_image) {
      read_image(opened);
    } else {
      read_scene(opened);
    }
  };
  folder.write(c.file, original);
  ASSERT_NO_THROW(read()) << "the undamaged file must open";

  std::mt19937 random(20260101);
  for (int i = 0; i < kMutationsPerFile; ++i) {
    std::string damaged = mutate(original, random);
    if (i % 3 == 2) damaged = damaged.empty() ? damaged : mutate(damaged, random);
    folder.write(c.file, damaged);
    const int result = run_limited(read);
    EXPECT_EQ(result, kGood) << c.name << " mutation " << i
                             << (result > 1000 ? ": signal " : ": code ") << result % 1000;
  }
}

TEST(GuideFuzz, DamagedGuidesEndInGuidesOrAnError) {
  constexpr int kMutations = 300;
  const auto scene = guide_test::lit_scenes()[0].build();
  const std::string original = sample_guides();
  std::mt19937 random(20260102);
  int read_whole = 0;
  for (int i = 0; i < kMutations; ++i) {
    std::string damaged = mutate(original, random);
    if (i % 3 == 2 && !damaged.empty()) damaged = mutate(damaged, random);
    const int result = run_limited([&] {
      // What can be read must be judged without harm, too.
      for (const GuidePath& guide : parse_guides(damaged, "damaged")) check_guide(*scene, guide);
    });
    EXPECT_EQ(result, kGood) << "mutation " << i;
    try {
      parse_guides(damaged, "damaged");
      ++read_whole;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(read_whole, 10) << "all are refused: what is behind the reader is not tried";
}

INSTANTIATE_TEST_SUITE_P(
    Formats, Fuzz,
    ::testing::Values(FuzzCase{"xml", sample_scene, "scene.xml", "scene.xml"},
                      FuzzCase{"include", sample_include, "included.xml", "scene.xml"},
                      FuzzCase{"obj", sample_obj, "mesh.obj", "scene.xml"},
                      FuzzCase{"ply_text", sample_ply_text, "mesh.ply", "scene.xml"},
                      FuzzCase{"ply_binary", sample_ply_little, "mesh.ply", "scene.xml"},
                      FuzzCase{"serialized", sample_serialized_4, "mesh.serialized", "scene.xml"},
                      FuzzCase{"gltf", sample_gltf, "scene.gltf", "scene.gltf"},
                      FuzzCase{"glb", sample_glb, "scene.glb", "scene.glb"},
                      FuzzCase{"png", sample_png, "image", "image"},
                      FuzzCase{"jpeg", sample_jpeg, "image", "image"},
                      FuzzCase{"hdr", sample_hdr, "image", "image"},
                      FuzzCase{"bmp", sample_bmp, "image", "image"},
                      FuzzCase{"tga", sample_tga, "image", "image"},
                      FuzzCase{"exr", sample_exr, "image", "image"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace guidelight::test
