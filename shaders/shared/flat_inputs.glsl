// What the vertex stage hands on the same to all fragments of a sprite: cheaper than fetching it
// from the buffer for each of them.

#ifdef VERTEX_STAGE
#define Flat flat out
#else
#define Flat flat in
#endif
