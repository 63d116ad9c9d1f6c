// Tables of library-inl.h.
#pragma once

// clang-format off
namespace verisim::functions {

// sin(k pi / 16) as sums of two numbers.
alignas(64) inline constexpr double kSineOf16ths[16] = {
    0, 0x1.8f8b83c69a60bp-3, 0x1.87de2a6aea963p-2, 0x1.1c73b39ae68c8p-1,
    0x1.6a09e667f3bcdp-1, 0x1.a9b66290ea1a3p-1, 0x1.d906bcf328d46p-1, 0x1.f6297cff75cb0p-1,
    1, 0x1.f6297cff75cb0p-1, 0x1.d906bcf328d46p-1, 0x1.a9b66290ea1a3p-1,
    0x1.6a09e667f3bcdp-1, 0x1.1c73b39ae68c8p-1, 0x1.87de2a6aea963p-2, 0x1.8f8b83c69a60bp-3};
alignas(64) inline constexpr double kSineOf16thsLow[16] = {
    0, -0x1.26d19b9ff8d82p-57, -0x1.72cedd3d5a610p-57, 0x1.b25dd267f6600p-55,
    -0x1.bdd3413b26456p-55, 0x1.9f630e8b6dac8p-60, 0x1.457e610231ac2p-56, 0x1.562172a361fd3p-56,
    0, 0x1.562172a361fd3p-56, 0x1.457e610231ac2p-56, 0x1.9f630e8b6dac8p-60,
    -0x1.bdd3413b26456p-55, 0x1.b25dd267f6600p-55, -0x1.72cedd3d5a610p-57, -0x1.26d19b9ff8d82p-57};
// atan(k / 64) as a sum of two numbers.
struct ArcOf64th {
  double hi, lo;
};
inline constexpr ArcOf64th kArcOf64ths[65] = {
    {0, 0}, {0x1.fff555bbb729bp-7, -0x1.220c39d4dff50p-61}, {0x1.ffd55bba97625p-6, -0x1.5ec431444912cp-60},
    {0x1.7fb818430da2ap-5, -0x1.86ef8f794f105p-63}, {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.3f59f0e7c559dp-4, 0x1.ac4ce285df847p-58},
    {0x1.7ee182602f10fp-4, -0x1.cfb654c0c3d98p-58}, {0x1.be39ebe6f07c3p-4, 0x1.f7b8f29a05987p-58},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.1e1fafb043727p-3, -0x1.b485914dacf8cp-59}, {0x1.3d6eee8c6626cp-3, 0x1.61a3b0ce9281bp-57},
    {0x1.5c9811e3ec26ap-3, -0x1.054ab2c010f3dp-58},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58}, {0x1.9a6a8e96c8626p-3, 0x1.cf601e7b4348ep-59},
    {0x1.b90d7529260a2p-3, 0x1.17b10d2e0e5abp-61},
    {0x1.d77d5df205736p-3, 0x1.c648d1534597ep-57}, {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.09dc597d86362p-2, 0x1.62e47390cb865p-56},
    {0x1.18bf5a30bf178p-2, 0x1.30ca4748b1bf9p-57}, {0x1.278372057ef46p-2, -0x1.077cdd36dfc81p-56},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.44aa436c2af0ap-2, -0x1.5d5e43c55b3bap-56}, {0x1.530ad9951cd4ap-2, -0x1.2566480884082p-57},
    {0x1.614840309cfe2p-2, -0x1.a725715711f00p-56},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56}, {0x1.7d5604b63b3f7p-2, 0x1.69c885c2b249ap-56},
    {0x1.8b24d394a1b25p-2, 0x1.b6d0ba3748fa8p-56},
    {0x1.98cd5454d6b18p-2, 0x1.9e6c988fd0a77p-56}, {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.b3a911da65c6cp-2, 0x1.ae187b1ca5040p-56},
    {0x1.c0db4c94ec9f0p-2, -0x1.cc1ce70934c34p-56}, {0x1.cde53432c1351p-2, -0x1.a2cfa4418f1adp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.e77eb7f175a34p-2, 0x1.0e53dc1bf3435p-56}, {0x1.f40dd0b541418p-2, -0x1.a3992dc382a23p-57},
    {0x1.0039c73c1a40cp-1, -0x1.b32c949c9d593p-55},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56}, {0x1.0c6145b5b43dap-1, 0x1.974fa13b5404fp-58},
    {0x1.1255d9bfbd2a9p-1, -0x1.2bdaee1c0ee35p-58},
    {0x1.1835a88be7c13p-1, 0x1.c621cec00c301p-55}, {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.23b71e2cc9e6ap-1, 0x1.c421c9f38224ep-57},
    {0x1.2958e59308e31p-1, -0x1.09e73b0c6c087p-56}, {0x1.2ee628406cbcap-1, 0x1.c5d5e9ff0cf8dp-55},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.39c391cd4171ap-1, -0x1.2304331d8bf46p-55}, {0x1.3f13fb89e96f4p-1, 0x1.ecf8b492644f0p-56},
    {0x1.445065b795b56p-1, -0x1.f76d0163f79c8p-56},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56}, {0x1.4e8de5bb6ec04p-1, 0x1.4a33dbeb3796cp-55},
    {0x1.538f57b89061fp-1, -0x1.1bb74abda520cp-55},
    {0x1.587d81f732fbbp-1, -0x1.5e5c9d8c5a950p-56}, {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.6220d115d7b8ep-1, -0x1.2b785350ee8c1p-57},
    {0x1.66d663923e087p-1, -0x1.6ea6febe8bbbap-56}, {0x1.6b798920b3d99p-1, -0x1.a80386188c50ep-55},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.748978fba8e0fp-1, 0x1.7b2a6165884a1p-59}, {0x1.78f6bbd5d315ep-1, 0x1.406a089803740p-55},
    {0x1.7d528289fa093p-1, 0x1.560821e2f3aa9p-55},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56}, {0x1.85d69576cc2c5p-1, 0x1.6b66e7fc8b8c3p-57},
    {0x1.89ff5ff57f1f8p-1, -0x1.55b9a5e177a1bp-55},
    {0x1.8e17aa99cc05ep-1, -0x1.ec182ab042f61p-56}, {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};
// For logarithms: approximate reciprocals c of numbers by the four bits behind the point (those from 6 on of numbers
// below 1), and -ln c as sums of two numbers.
alignas(64) inline constexpr double kReciprocals[16] = {
    1, 0x1.d41d41d41d41dp-1, 0x1.bacf914c1bad0p-1, 0x1.a41a41a41a41ap-1,
    0x1.8f9c18f9c18fap-1, 0x1.7d05f417d05f4p-1, 0x1.6c16c16c16c17p+0, 0x1.5c9882b931057p+0,
    0x1.4e5e0a72f0539p+0, 0x1.4141414141414p+0, 0x1.3521cfb2b78c1p+0, 0x1.29e4129e4129ep+0,
    0x1.1f7047dc11f70p+0, 0x1.15b1e5f75270dp+0, 0x1.0c9714fbcda3bp+0, 1};
alignas(64) inline constexpr double kLogarithms[16] = {
    0, 0x1.6f0d28ae56b4ep-4, 0x1.29552f81ff521p-3, 0x1.9525a9cf456b6p-3,
    0x1.fb9186d5e3e29p-3, 0x1.2e8e2bae11d31p-2, -0x1.68ac83e9c6a15p-2, -0x1.3c25277333183p-2,
    -0x1.1178e8227e47ap-2, -0x1.d1037f2655e7bp-3, -0x1.823c16551a3c0p-3, -0x1.365fcb0159014p-3,
    -0x1.da7276384469ep-4, -0x1.4d3115d207eacp-4, -0x1.894aa149fb34bp-5, 0};
alignas(64) inline constexpr double kLogarithmsLow[16] = {
    0, -0x1.20db323097324p-59, 0x1.301771c407dc0p-57, -0x1.26fb3e2b1d1dap-57,
    0x1.355519b0de535p-57, -0x1.1e99b72bd7bf2p-57, 0x1.acd8a9145ff44p-57, -0x1.152d81af5713ap-56,
    -0x1.b8ce2d07f1cb7p-56, 0x1.3f3adb7b71cbcp-58, -0x1.6dcd318f4187ep-57, -0x1.bea08d2dca256p-57,
    -0x1.401fa71733017p-58, -0x1.da7d0b1e10b2fp-60, 0x1.2ba0b44cfaee5p-59, 0};
// 2^(k / 16) as sums of two numbers.
alignas(64) inline constexpr double kPowersOf2[16] = {
    1, 0x1.0b5586cf9890fp+0, 0x1.172b83c7d517bp+0, 0x1.2387a6e756238p+0,
    0x1.306fe0a31b715p+0, 0x1.3dea64c123422p+0, 0x1.4bfdad5362a27p+0, 0x1.5ab07dd485429p+0,
    0x1.6a09e667f3bcdp+0, 0x1.7a11473eb0187p+0, 0x1.8ace5422aa0dbp+0, 0x1.9c49182a3f090p+0,
    0x1.ae89f995ad3adp+0, 0x1.c199bdd85529cp+0, 0x1.d5818dcfba487p+0, 0x1.ea4afa2a490dap+0};
alignas(64) inline constexpr double kPowersOf2Low[16] = {
    0, 0x1.8a62e4adc610bp-54, -0x1.19041b9d78a76p-55, 0x1.9b07eb6c70573p-54,
    0x1.6f46ad23182e4p-55, 0x1.ada0911f09ebcp-55, 0x1.d4397afec42e2p-56, 0x1.6324c054647adp-54,
    -0x1.bdd3413b26456p-54, -0x1.41577ee04992fp-55, 0x1.6e9f156864b27p-54, 0x1.c7c46b071f2bep-56,
    0x1.7a1cd345dcc81p-54, 0x1.11065895048ddp-55, 0x1.2ed02d75b3707p-55, -0x1.e9c23179c2893p-54};

// Arguments from 0 to 22 for which sinh and cosh differ between libraries that fuse other products in e^x - 1, or sum
// its polynomial in another order: each of 23 such ways gives other results for nine of them or more. Some stand twice.
inline constexpr int kTellingArguments = 48;
alignas(64) inline constexpr double kTelling[kTellingArguments] = {
    0x1.886781b915fbep-2, 0x1.8b9dfc7096a35p-3, 0x1.f93de42058228p-1, 0x1.37c472827491dp-2, 0x1.c485fb929800cp+0,
    0x1.d2204f8c03338p-4, 0x1.4aa455d9bf45ep-2, 0x1.bba411b6d4302p+0, 0x1.4af54b5761087p-2, 0x1.12abfabf150acp+3,
    0x1.588a01b132589p-3, 0x1.c28ae10cc9358p+0, 0x1.cc4c9f003971fp-3, 0x1.17191fc28313p-2, 0x1.542e28ad601d5p+4,
    0x1.e7add9a897p-3, 0x1.bdcf7121e291fp+0, 0x1.40db191ec461bp-3, 0x1.3993a78a6c0a5p-2, 0x1.1a11ce166cabp+0,
    0x1.5691045253787p-2, 0x1.0a589501af5d6p+0, 0x1.feff2d7326e0bp-3, 0x1.0342f5e8094d7p+4, 0x1.506e90f3682abp-2,
    0x1.85435d0e603fbp-2, 0x1.053b209ff93a7p+4, 0x1.52e71038510d3p+4, 0x1.4b9a8339af0b8p-2, 0x1.fa1975c6ce9dfp-1,
    0x1.3de3195d9407fp-2, 0x1.0b32be7f603b2p+0, 0x1.5a45f6d5d879ap-2, 0x1.44561988cd739p-2, 0x1.5b271a386f869p-2,
    0x1.538bdb2e38f7fp-2, 0x1.0c0ff6c4429cep-2, 0x1.5dd1dcc04adafp-2, 0x1.2f1749c7ee43ap-2, 0x1.22e82169588efp-2,
    0x1.59640a0eec416p-2, 0x1.f4312d4568612p-3, 0x1.25700298c21c1p-2, 0x1.4a3dc5f0c2cbcp-2, 0x1.886781b915fbep-2,
    0x1.8b9dfc7096a35p-3, 0x1.f93de42058228p-1, 0x1.37c472827491dp-2};

}  // namespace verisim::functions
// clang-format on
