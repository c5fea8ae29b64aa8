#include "hatchway/io/gltf/check/gltf_rules.hpp"

#include "hatchway/core/limits.hpp"

namespace hw {
namespace {

using enum RuleKind;

constexpr double kMostBytes = 9e15;  // whole numbers up to here are exact in a double
constexpr int kComponents[] = {5120, 5121, 5122, 5123, 5125, 5126};
constexpr int kIndexComponents[] = {5121, 5123, 5125};
constexpr std::string_view kAccessorTypes[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
constexpr std::string_view kAlphaModes[] = {"OPAQUE", "MASK", "BLEND"};
constexpr std::string_view kCameraTypes[] = {"perspective", "orthographic"};
constexpr std::string_view kInterpolations[] = {"LINEAR", "STEP", "CUBICSPLINE"};
constexpr int kMagFilters[] = {9728, 9729};
constexpr int kMinFilters[] = {9728, 9729, 9984, 9985, 9986, 9987};
constexpr int kWraps[] = {33071, 33648, 10497};

constexpr PropertyRule kAsset[] = {
    {.name = "version", .kind = text, .is_required = true},
    {.name = "minVersion", .kind = text},
};

// Accessors, buffers

constexpr PropertyRule kSparseIndices[] = {
    {.name = "bufferView", .kind = reference, .is_required = true, .target = "/bufferViews"},
    {.name = "byteOffset", .kind = whole, .min = 0, .max = kMostBytes},
    {.name = "componentType", .kind = whole, .is_required = true, .wholes = kIndexComponents},
};
constexpr PropertyRule kSparseValues[] = {
    {.name = "bufferView", .kind = reference, .is_required = true, .target = "/bufferViews"},
    {.name = "byteOffset", .kind = whole, .min = 0, .max = kMostBytes},
};
constexpr PropertyRule kSparse[] = {
    {.name = "count", .kind = whole, .is_required = true, .min = 1, .max = kMostBytes},
    {.name = "indices", .kind = object, .is_required = true, .members = kSparseIndices},
    {.name = "values", .kind = object, .is_required = true, .members = kSparseValues},
};
constexpr PropertyRule kAccessors[] = {
    {.name = "bufferView", .kind = reference, .target = "/bufferViews"},
    {.name = "byteOffset", .kind = whole, .min = 0, .max = kMostBytes},
    {.name = "componentType", .kind = whole, .is_required = true, .wholes = kComponents},
    {.name = "normalized", .kind = flag},
    {.name = "count", .kind = whole, .is_required = true, .min = 1, .max = 3.0 * limits::kMaxVertices},
    {.name = "type", .kind = text, .is_required = true, .texts = kAccessorTypes},
    {.name = "max", .kind = reals, .min_size = 1, .max_size = 16},
    {.name = "min", .kind = reals, .min_size = 1, .max_size = 16},
    {.name = "sparse", .kind = object, .members = kSparse},
};
constexpr PropertyRule kBuffers[] = {
    {.name = "uri", .kind = text},
    {.name = "byteLength", .kind = whole, .is_required = true, .min = 1, .max = limits::kMaxFileBytes},
};
constexpr PropertyRule kBufferViews[] = {
    {.name = "buffer", .kind = reference, .is_required = true, .target = "/buffers"},
    {.name = "byteOffset", .kind = whole, .min = 0, .max = kMostBytes},
    {.name = "byteLength", .kind = whole, .is_required = true, .min = 1, .max = kMostBytes},
    {.name = "byteStride", .kind = whole, .min = 4, .max = 252},
};

// Textures, materials

constexpr PropertyRule kImages[] = {
    {.name = "uri", .kind = text},
    {.name = "mimeType", .kind = text},
    {.name = "bufferView", .kind = reference, .target = "/bufferViews"},
};
constexpr PropertyRule kSamplers[] = {
    {.name = "magFilter", .kind = whole, .wholes = kMagFilters},
    {.name = "minFilter", .kind = whole, .wholes = kMinFilters},
    {.name = "wrapS", .kind = whole, .wholes = kWraps},
    {.name = "wrapT", .kind = whole, .wholes = kWraps},
};
constexpr PropertyRule kOtherSource[] = {{.name = "source", .kind = reference, .target = "/images"}};
constexpr PropertyRule kTextureExtensions[] = {
    {.name = "EXT_texture_webp", .kind = object, .members = kOtherSource},
    {.name = "KHR_texture_basisu", .kind = object, .members = kOtherSource},
};
constexpr PropertyRule kTextures[] = {
    {.name = "sampler", .kind = reference, .target = "/samplers"},
    {.name = "source", .kind = reference, .target = "/images"},
    {.name = "extensions", .kind = object, .members = kTextureExtensions},
};
constexpr PropertyRule kTextureTransform[] = {
    {.name = "offset", .kind = reals, .min = -1e9, .max = 1e9, .min_size = 2, .max_size = 2},
    {.name = "rotation", .kind = real, .min = -1e9, .max = 1e9},
    {.name = "scale", .kind = reals, .min = -1e9, .max = 1e9, .min_size = 2, .max_size = 2},
    {.name = "texCoord", .kind = whole, .min = 0, .max = 1000},
};
constexpr PropertyRule kTextureInfoExtensions[] = {
    {.name = "KHR_texture_transform", .kind = object, .members = kTextureTransform},
};
constexpr PropertyRule kTextureInfo[] = {
    {.name = "index", .kind = reference, .is_required = true, .target = "/textures"},
    {.name = "texCoord", .kind = whole, .min = 0, .max = 1000},
    {.name = "scale", .kind = real, .min = -1e9, .max = 1e9},  // normalTexture
    {.name = "strength", .kind = real, .min = 0, .max = 1},    // occlusionTexture
    {.name = "extensions", .kind = object, .members = kTextureInfoExtensions},
};
constexpr PropertyRule kMetallicRoughness[] = {
    {.name = "baseColorFactor", .kind = reals, .min = 0, .max = 1, .min_size = 4, .max_size = 4},
    {.name = "baseColorTexture", .kind = object, .members = kTextureInfo},
    {.name = "metallicFactor", .kind = real, .min = 0, .max = 1},
    {.name = "roughnessFactor", .kind = real, .min = 0, .max = 1},
    {.name = "metallicRoughnessTexture", .kind = object, .members = kTextureInfo},
};
constexpr PropertyRule kEmissiveStrength[] = {{.name = "emissiveStrength", .kind = real, .min = 0, .max = 1e9}};
constexpr PropertyRule kMaterialExtensions[] = {
    {.name = "KHR_materials_unlit", .kind = object},
    {.name = "KHR_materials_emissive_strength", .kind = object, .members = kEmissiveStrength},
};
constexpr PropertyRule kMaterials[] = {
    {.name = "name", .kind = text},
    {.name = "pbrMetallicRoughness", .kind = object, .members = kMetallicRoughness},
    {.name = "normalTexture", .kind = object, .members = kTextureInfo},
    {.name = "occlusionTexture", .kind = object, .members = kTextureInfo},
    {.name = "emissiveTexture", .kind = object, .members = kTextureInfo},
    {.name = "emissiveFactor", .kind = reals, .min = 0, .max = 1, .min_size = 3, .max_size = 3},
    {.name = "alphaMode", .kind = text, .texts = kAlphaModes},
    {.name = "alphaCutoff", .kind = real, .min = 0, .max = 1e9},
    {.name = "doubleSided", .kind = flag},
    {.name = "extensions", .kind = object, .members = kMaterialExtensions},
};

// Meshes

constexpr PropertyRule kEdgeVisibility[] = {{.name = "visibility", .kind = reference, .target = "/accessors"}};
constexpr PropertyRule kPrimitiveExtensions[] = {
    {.name = "EXT_mesh_primitive_edge_visibility", .kind = object, .members = kEdgeVisibility},
};
constexpr PropertyRule kPrimitives[] = {
    {.name = "attributes", .kind = named_references, .is_required = true, .target = "/accessors"},
    {.name = "indices", .kind = reference, .target = "/accessors"},
    {.name = "targets", .kind = named_references_list, .target = "/accessors"},
    {.name = "material", .kind = reference, .target = "/materials"},
    {.name = "mode", .kind = whole, .min = 0, .max = 6},
    {.name = "extensions", .kind = object, .members = kPrimitiveExtensions},
};
constexpr PropertyRule kMeshes[] = {
    {.name = "primitives", .kind = objects, .is_required = true, .members = kPrimitives},
    {.name = "weights", .kind = reals},
};

// Nodes, cameras, lights

constexpr PropertyRule kNodeLight[] = {
    {.name = "light", .kind = reference, .is_required = true, .target = "/extensions/KHR_lights_punctual/lights"},
};
constexpr PropertyRule kInstancing[] = {
    {.name = "attributes", .kind = named_references, .is_required = true, .target = "/accessors"},
};
constexpr PropertyRule kNodeExtensions[] = {
    {.name = "KHR_lights_punctual", .kind = object, .members = kNodeLight},
    {.name = "EXT_mesh_gpu_instancing", .kind = object, .members = kInstancing},
};
constexpr PropertyRule kNodes[] = {
    {.name = "name", .kind = text},
    {.name = "camera", .kind = reference, .target = "/cameras"},
    {.name = "children", .kind = references, .target = "/nodes"},
    {.name = "skin", .kind = reference, .target = "/skins"},
    {.name = "mesh", .kind = reference, .target = "/meshes"},
    {.name = "matrix", .kind = reals, .min = -1e30, .max = 1e30, .min_size = 16, .max_size = 16},
    {.name = "translation", .kind = reals, .min = -1e30, .max = 1e30, .min_size = 3, .max_size = 3},
    {.name = "rotation", .kind = reals, .min = -1.001, .max = 1.001, .min_size = 4, .max_size = 4},
    {.name = "scale", .kind = reals, .min = -1e30, .max = 1e30, .min_size = 3, .max_size = 3},
    {.name = "weights", .kind = reals},
    {.name = "extensions", .kind = object, .members = kNodeExtensions},
};
constexpr PropertyRule kPerspective[] = {
    {.name = "yfov", .kind = real, .is_required = true, .min = 1e-6, .max = 1e3},
    {.name = "znear", .kind = real, .is_required = true, .min = 0},
    {.name = "zfar", .kind = real, .min = 0},
    {.name = "aspectRatio", .kind = real, .min = 0},
};
constexpr PropertyRule kOrthographic[] = {
    {.name = "xmag", .kind = real, .is_required = true},
    {.name = "ymag", .kind = real, .is_required = true},
    {.name = "zfar", .kind = real, .is_required = true, .min = 0},
    {.name = "znear", .kind = real, .is_required = true, .min = 0},
};
constexpr PropertyRule kCameras[] = {
    {.name = "name", .kind = text},
    {.name = "type", .kind = text, .is_required = true, .texts = kCameraTypes},
    {.name = "perspective", .kind = object, .members = kPerspective},
    {.name = "orthographic", .kind = object, .members = kOrthographic},
};
constexpr PropertyRule kSpot[] = {
    {.name = "innerConeAngle", .kind = real, .min = 0, .max = 1.5707964},
    {.name = "outerConeAngle", .kind = real, .min = 0, .max = 1.5707964},
};
constexpr PropertyRule kLights[] = {
    {.name = "name", .kind = text},
    {.name = "type", .kind = text, .is_required = true},
    {.name = "color", .kind = reals, .min = 0, .max = 1, .min_size = 3, .max_size = 3},
    {.name = "intensity", .kind = real, .min = 0, .max = 1e12},
    {.name = "range", .kind = real, .min = 1e-9, .max = 1e12},
    {.name = "spot", .kind = object, .members = kSpot},
};
constexpr PropertyRule kLightList[] = {
    {.name = "lights", .kind = objects, .is_required = true, .members = kLights},
};
constexpr PropertyRule kRootExtensions[] = {
    {.name = "KHR_lights_punctual", .kind = object, .members = kLightList},
};
constexpr PropertyRule kScenes[] = {{.name = "nodes", .kind = references, .target = "/nodes"}};

// Skins and animations are not played, but what they break would be broken input all the same.

constexpr PropertyRule kSkins[] = {
    {.name = "inverseBindMatrices", .kind = reference, .target = "/accessors"},
    {.name = "skeleton", .kind = reference, .target = "/nodes"},
    {.name = "joints", .kind = references, .is_required = true, .target = "/nodes"},
};
constexpr PropertyRule kTarget[] = {
    {.name = "node", .kind = reference, .target = "/nodes"},
    {.name = "path", .kind = text, .is_required = true},
};
constexpr PropertyRule kChannels[] = {
    {.name = "sampler", .kind = whole, .is_required = true, .min = 0, .max = 1e9},
    {.name = "target", .kind = object, .is_required = true, .members = kTarget},
};
constexpr PropertyRule kAnimationSamplers[] = {
    {.name = "input", .kind = reference, .is_required = true, .target = "/accessors"},
    {.name = "output", .kind = reference, .is_required = true, .target = "/accessors"},
    {.name = "interpolation", .kind = text, .texts = kInterpolations},
};
constexpr PropertyRule kAnimations[] = {
    {.name = "channels", .kind = objects, .is_required = true, .members = kChannels},
    {.name = "samplers", .kind = objects, .is_required = true, .members = kAnimationSamplers},
};

constexpr PropertyRule kRoot[] = {
    {.name = "asset", .kind = object, .is_required = true, .members = kAsset},
    {.name = "scene", .kind = reference, .target = "/scenes"},
    {.name = "extensions", .kind = object, .members = kRootExtensions},
    {.name = "buffers", .kind = objects, .members = kBuffers},
    {.name = "bufferViews", .kind = objects, .members = kBufferViews},
    {.name = "accessors", .kind = objects, .members = kAccessors},
    {.name = "images", .kind = objects, .members = kImages},
    {.name = "samplers", .kind = objects, .members = kSamplers},
    {.name = "textures", .kind = objects, .members = kTextures},
    {.name = "materials", .kind = objects, .members = kMaterials},
    {.name = "meshes", .kind = objects, .members = kMeshes},
    {.name = "nodes", .kind = objects, .max_size = limits::kMaxNodes, .members = kNodes},
    {.name = "cameras", .kind = objects, .members = kCameras},
    {.name = "scenes", .kind = objects, .members = kScenes},
    {.name = "skins", .kind = objects, .members = kSkins},
    {.name = "animations", .kind = objects, .members = kAnimations},
};

}  // namespace

std::span<const PropertyRule> gltf_rules()
{
    return kRoot;
}

}  // namespace hw
