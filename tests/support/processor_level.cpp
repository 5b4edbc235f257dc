/// Linked into a copy of fumon, this stands before libgcc's look at the processor, so that every
/// loop compiled for several levels (support/multiversion.h) takes the version for a lesser one:
/// FUMON_PROCESSOR_FEATURES has libgcc's bits (2^10: AVX2), 0 being plain x86-64.
extern "C" {

struct ProcessorModel {
    unsigned vendor;
    unsigned type;
    unsigned subtype;
    unsigned features;
};

[[gnu::visibility("hidden")]] ProcessorModel __cpu_model = {1, 0, 0, FUMON_PROCESSOR_FEATURES};
[[gnu::visibility("hidden")]] unsigned __cpu_features2[8] = {};
[[gnu::visibility("hidden")]] int __cpu_indicator_init();

int __cpu_indicator_init() {
    return 0;
}
}
