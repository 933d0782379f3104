// Depth alone: what is hidden is then not shaded.

void main() {}
