#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "renderer/image/filter.h"
#include "renderer/image/image.h"
#include "renderer/math/vector.h"

/// What a scene file says, as plain editable data. Readers (renderer/io) produce it, Scene is built
/// from it, and editors change a copy. Lists refer to each other by index; a texture or BSDF refers
/// only to entries before itself, so cycles cannot be written.
namespace guidelight {

inline constexpr int kNone = -1;

// ---------------------------------------------------------------------------------------------------
// Textures

/// A colour that may vary over the surface: value × texture(uv), or just the value without a
/// texture.
struct ColorInput {
  Color value{1.0f};
  int texture = kNone;
};

/// A scalar that may vary: value × one channel of the texture; channel kNone takes its luminance.
struct FloatInput {
  float value = 0;
  int texture = kNone;
  int channel = kNone;
};

enum class WrapMode { Repeat, Mirror, Clamp, Zero, One };
enum class TextureFilter { Nearest, Bilinear };

struct BitmapTexture {
  std::shared_ptr<const Image> image;  // linear values, top row first; v = 0 is the bottom row
  Mat3 uv_transform{1.0f};             // applied to (u, v, 1)
  WrapMode wrap_u = WrapMode::Repeat;
  WrapMode wrap_v = WrapMode::Repeat;
  TextureFilter filter = TextureFilter::Bilinear;
};

struct CheckerboardTexture {
  ColorInput color0{Color(0.4f)};  // where both or neither of the halves of (u,v) are ≥ 0.5
  ColorInput color1{Color(0.2f)};
  Mat3 uv_transform{1.0f};
};

/// The mesh's own colours, interpolated; white where a mesh has none.
struct VertexColorTexture {};

struct TextureDescription {
  std::string name;
  int line = 0;
  std::variant<BitmapTexture, CheckerboardTexture, VertexColorTexture> model;
};

// ---------------------------------------------------------------------------------------------------
// BSDFs. `int_ior` is on the side the normal points away from. Roughness α = 0 means perfectly
// smooth.

enum class Microfacet { Beckmann, Ggx };

struct DiffuseBsdf {
  ColorInput reflectance{Color(0.5f)};
};

/// Oren–Nayar; alpha is a roughness as of Beckmann's facets, √2 times the standard deviation of
/// their tilt [rad].
struct RoughDiffuseBsdf {
  ColorInput reflectance{Color(0.5f)};
  FloatInput alpha{0.2f};
};

/// eta + i·k per colour channel, relative to the outside. eta = 0, k = 1 reflects everything.
struct ConductorBsdf {
  Color eta{0.0f};
  Color k{1.0f};
  ColorInput specular_reflectance{};
  FloatInput alpha_u{0.0f};
  FloatInput alpha_v{0.0f};
  Microfacet distribution = Microfacet::Beckmann;
};

struct DielectricBsdf {
  float int_ior = 1.5046f;
  float ext_ior = 1.000277f;
  ColorInput specular_reflectance{};
  ColorInput specular_transmittance{};
  FloatInput alpha_u{0.0f};
  FloatInput alpha_v{0.0f};
  Microfacet distribution = Microfacet::Beckmann;
};

/// A sheet of glass too thin to bend light: both interfaces with all their inter-reflections.
struct ThinDielectricBsdf {
  float int_ior = 1.5046f;
  float ext_ior = 1.000277f;
  ColorInput specular_reflectance{};
  ColorInput specular_transmittance{};
};

/// Diffuse base under a dielectric coat (Mitsuba's plastic and roughplastic).
struct PlasticBsdf {
  float int_ior = 1.49f;
  float ext_ior = 1.000277f;
  ColorInput diffuse_reflectance{Color(0.5f)};
  ColorInput specular_reflectance{};
  bool nonlinear = false;  // colour shift by internal scattering
  FloatInput alpha{0.0f};
  Microfacet distribution = Microfacet::Beckmann;
};

struct PhongBsdf {
  ColorInput diffuse_reflectance{Color(0.5f)};
  ColorInput specular_reflectance{Color(0.2f)};
  FloatInput exponent{30.0f};
};

struct WardBsdf {
  enum class Variant { Ward, WardDuer, Balanced } variant = Variant::Balanced;
  ColorInput diffuse_reflectance{Color(0.5f)};
  ColorInput specular_reflectance{Color(0.2f)};
  FloatInput alpha_u{0.1f};
  FloatInput alpha_v{0.1f};
};

/// A smooth dielectric layer over another BSDF, with absorption sigma_a × thickness.
struct CoatingBsdf {
  int nested = kNone;
  float int_ior = 1.5046f;
  float ext_ior = 1.000277f;
  float thickness = 1;
  ColorInput sigma_a{Color(0.0f)};
  ColorInput specular_reflectance{};
};

/// (1 - weight)·first + weight·second.
struct BlendBsdf {
  FloatInput weight{0.5f};
  int first = kNone;
  int second = kNone;
};

/// Lets light pass straight through with probability 1 - opacity.
struct MaskBsdf {
  FloatInput opacity{0.5f};
  int nested = kNone;
};

/// Gives a one-sided BSDF a back side; `back` may equal `front`.
struct TwoSidedBsdf {
  int front = kNone;
  int back = kNone;
};

/// An interface that does nothing to light (the boundary of a medium).
struct NullBsdf {};

/// Replaces the shading normal; texture values (0..1)³ encode (-1..1)³ in the tangent frame: z along
/// the normal n, x along dpdu, y along n × x (Mitsuba) or, of ± that, on the side where v falls
/// (glTF, also where a model mirrors its texture).
struct NormalMapBsdf {
  int texture = kNone;
  int nested = kNone;
  bool y_is_against_v = false;
};

/// Perturbs the shading normal as if the surface were displaced by scale × luminance(texture).
struct BumpMapBsdf {
  int texture = kNone;
  float scale = 1;
  int nested = kNone;
};

struct BsdfDescription {
  std::string name;
  int line = 0;
  std::variant<DiffuseBsdf, RoughDiffuseBsdf, ConductorBsdf, DielectricBsdf, ThinDielectricBsdf,
               PlasticBsdf, PhongBsdf, WardBsdf, CoatingBsdf, BlendBsdf, MaskBsdf, TwoSidedBsdf,
               NullBsdf, NormalMapBsdf, BumpMapBsdf>
      model;
};

// ---------------------------------------------------------------------------------------------------
// Shapes

/// Homogeneous medium; only absorption is simulated.
struct MediumDescription {
  std::string name;
  int line = 0;
  Color sigma_a{0.0f};  // [1 / scene unit]
};

/// Triangle mesh in object space. `normals`, `uvs` and `colors` are empty or have one entry per
/// position.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  // unit length
  std::vector<Vec2> uvs;
  std::vector<Color> colors;
  std::vector<std::array<uint32_t, 3>> triangles;
};

struct MeshShape {
  std::shared_ptr<const Mesh> mesh;
};
/// In the shape's own space: unit sphere; unit disk in z = 0, normal +z; side of the cylinder of
/// radius 1 around z from z = 0 to z = 1, normal outwards.
struct SphereShape {};
struct DiskShape {};
struct CylinderShape {};
/// A copy of group `group` of SceneDescription::groups.
struct InstanceShape {
  int group = kNone;
};

struct ShapeDescription {
  std::string name;
  int line = 0;
  std::variant<MeshShape, SphereShape, DiskShape, CylinderShape, InstanceShape> geometry;
  Mat4 to_world{1.0f};
  bool flip_normals = false;
  int bsdf = kNone;                    // kNone: diffuse grey
  std::optional<ColorInput> radiance;  // makes the shape an area light [W/(m² sr)]
  bool is_medium_boundary = false;
  int interior = kNone;  // media; kNone is vacuum, meaningful only at a medium boundary
  int exterior = kNone;
};

/// Shapes that instances copy, in the group's own space; groups do not nest.
struct ShapeGroup {
  std::string name;
  int line = 0;
  std::vector<ShapeDescription> shapes;
};

// ---------------------------------------------------------------------------------------------------
// Lights that are not shapes

struct PointEmitter {
  Vec3 position{0};
  Color intensity{1.0f};  // [W/sr]
};

/// Along local +z; full intensity within beam_width, smooth fall-off to zero at cutoff_angle [rad].
struct SpotEmitter {
  Mat4 to_world{1.0f};
  Color intensity{1.0f};  // [W/sr]
  float cutoff_angle = 20 * kPi / 180;
  float beam_width = 15 * kPi / 180;
  int texture = kNone;
};

struct DirectionalEmitter {
  Vec3 direction{0, 0, 1};  // the way the light travels
  Color irradiance{1.0f};   // on a surface that faces it [W/m²]
};

struct ConstantEmitter {
  Color radiance{1.0f};
};

/// Latitude-longitude image; its top row is +y, its left edge -z, its centre column +z and the
/// middle of its left half +x (Mitsuba's convention).
struct EnvironmentEmitter {
  std::shared_ptr<const Image> image;
  Mat4 to_world{1.0f};
  float scale = 1;
};

/// Daylight after Preetham et al. 1999; up is local +y.
struct SunSkyEmitter {
  bool sun = true;
  bool sky = true;
  Vec3 sun_direction{0, 1, 0};  // local, towards the sun, unit length
  float turbidity = 3;          // 1.7 to 10
  float sun_scale = 1;
  float sky_scale = 1;
  float sun_radius_scale = 1;
  Color ground_albedo{0.15f};  // of other sky models; Preetham's has no ground
  Mat4 to_world{1.0f};
};

/// Throws an image along local +z through a horizontal field of view [rad], +x to the left. A white
/// diffuse screen at z = 1 shows the image's own values times scale, as radiance [W/(m² sr)].
struct ProjectorEmitter {
  Mat4 to_world{1.0f};
  std::shared_ptr<const Image> image;
  float fov_x = 45 * kPi / 180;
  float scale = 1;
};

struct EmitterDescription {
  std::string name;
  int line = 0;
  std::variant<PointEmitter, SpotEmitter, DirectionalEmitter, ConstantEmitter, EnvironmentEmitter,
               SunSkyEmitter, ProjectorEmitter>
      model;
};

// ---------------------------------------------------------------------------------------------------
// Camera and the rest

enum class CameraModel { Perspective, ThinLens, Orthographic };
enum class FovAxis { X, Y, Diagonal, Smaller, Larger };

/// Looks along local +z with +y up and +x to the left of the picture (Mitsuba's convention). A
/// mirrored to_world gives a mirrored picture. Orthographic cameras see x in [-1,1] of their local
/// space, and of y as much as square pixels show.
struct CameraDescription {
  CameraModel model = CameraModel::Perspective;
  Mat4 to_world{1.0f};
  float fov = 50;  // [degrees] along fov_axis of the full picture
  FovAxis fov_axis = FovAxis::X;
  Vec2 principal_point_offset{0};  // as a share of the picture's width and height
  float near_clip = 1e-2f;
  float far_clip = 1e4f;
  float aperture_radius = 0;  // thin lens, scene units
  float focus_distance = 1;   // thin lens, scene units along +z
};

struct FilmDescription {
  int width = 768;
  int height = 576;
  int crop_x = 0;  // crop window in pixels; crop_width 0 means the whole picture
  int crop_y = 0;
  int crop_width = 0;
  int crop_height = 0;
  FilterSettings filter;
};

/// What the file asks of the renderer; the viewer and the command line may override it.
struct RenderHints {
  std::string integrator;        // as the file names it; may be unknown to us
  std::optional<int> max_depth;  // segments; 1 sees only emitters, -1 is unlimited
  std::optional<int> russian_roulette_depth;
  std::optional<int> samples_per_pixel;
};

struct SceneDescription {
  std::string name;
  std::string path;                            // the file it came from, empty if none
  std::string file_hash;                       // tells versions of that file apart
  std::map<std::string, std::string> defines;  // <default> variables it was read with
  std::vector<TextureDescription> textures;
  std::vector<BsdfDescription> bsdfs;
  std::vector<MediumDescription> media;
  std::vector<ShapeGroup> groups;
  std::vector<ShapeDescription> shapes;
  std::vector<EmitterDescription> emitters;
  CameraDescription camera;
  int camera_medium = kNone;
  FilmDescription film;
  RenderHints hints;
  std::vector<std::string> warnings;  // each a sentence with file and line
};

}  // namespace guidelight
