// Reads the images "object_ids" and "triangle_ids".

// The number that a texel holds, 0 where nothing was drawn: object + 1, or triangle + 1.
int hw_object_number(vec4 texel)
{
    ivec3 bytes = ivec3(texel.rgb * 255.0 + 0.5);
    return bytes.r + bytes.g * 256 + bytes.b * 65536;
}

int hw_style_number(vec4 texel) { return int(texel.a * 255.0 + 0.5); }

uint hw_triangle_number(vec4 texel)
{
    uvec4 bytes = uvec4(texel * 255.0 + 0.5);
    return bytes.r | bytes.g << 8 | bytes.b << 16 | bytes.a << 24;
}
