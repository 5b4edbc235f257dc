// A vector turned by the angle whose cosine and sine `by` holds.
vec2 rotated(vec2 p, vec2 by) { return vec2(by.x * p.x - by.y * p.y, by.y * p.x + by.x * p.y); }
