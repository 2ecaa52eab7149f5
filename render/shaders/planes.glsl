// The planes of all polytopes, in eye space: unit normals and distances from their volumes' centers.
uniform samplerBuffer planes;

vec4 plane_at(int index) { return texelFetch(planes, index); }
