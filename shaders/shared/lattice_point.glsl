// Where a ray of the lattice starts; in doubles for lattices whose products outgrow 31 bits.

#ifdef LATTICE_WIDE
#define Number double
#define Number3 dvec3
#else
#define Number int
#define Number3 ivec3
#endif

// origin + ((i * right + j * up) >> 12), rounding down.
Number3 latticePoint(ivec3 origin, ivec3 right, ivec3 up, ivec2 pixel) {
    Number3 along = Number(pixel.x) * Number3(right) + Number(pixel.y) * Number3(up);
#ifdef LATTICE_WIDE
    along = floor(along / 4096.0LF);
#else
    along = along >> 12;
#endif
    return Number3(origin) + along;
}
