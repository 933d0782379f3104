// Flat(location, component): what is the same for all fragments of a sprite. The vertex stage hands
// it on, which is cheaper than fetching it from the buffer for each of them; a compute stage sets
// it itself.

#if defined(VERTEX_STAGE)
#define Flat(place, part) layout(location = place, component = part) flat out
#elif defined(COMPUTE_STAGE)
#define Flat(place, part)
#else
#define Flat(place, part) layout(location = place, component = part) flat in
#endif
