// What software renderers would wait for, to the precision that a picture needs.

// 1 / sqrt(x) within 0.07 %, for x from 1e-24 to 1e24: a guess from the bits of the number and one step of Newton's with
// the constants of Moroz, Walczyk, Hrynchyshyn, Holimath and Cieslinski (2018).
float hw_inverse_sqrt(float x)
{
    float y = uintBitsToFloat(0x5f1ffff9u - (floatBitsToUint(x) >> 1u));
    return 0.703952253 * y * (2.38924456 - x * y * y);
}
