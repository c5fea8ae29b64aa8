// Numbers that a test makes on both sides, the same bits: see ShaderInputs of shader_inputs.hpp.
uniform int test_seed;

float test_pick(int number)
{
    uint pixel = uint(gl_FragCoord.y) * 4096u + uint(gl_FragCoord.x);
    uint h = (pixel * 64u + uint(number)) * 747796405u + uint(test_seed) * 2891336453u;
    h ^= h >> 16;
    h *= 2246822519u;
    h ^= h >> 13;
    h *= 3266489917u;
    h ^= h >> 16;
    return float(h >> 8) / 16777216.0;
}
