#include "parser/source/codes.h"

#include <algorithm>

namespace verisim::parser {
namespace {

constexpr CodeEntry kCodes[] = {
    {Code::illegal_character, "illegal-character", "A character that means nothing in SDL",
     "Outside strings and comments a scene consists of names, numbers and the usual signs. Text pasted from a web page "
     "or a word processor often brings typographic quotes, dashes and spaces that look right and are not.",
     "sphere { 0, 1 } \xc2\xa7", "sphere { 0, 1 }"},
    {Code::unterminated_string, "unterminated-string", "A string without its closing quote",
     "A string may run over several lines, so a forgotten quote swallows the text up to the next quote, or up to the "
     "end of the file. The message shows where the string was opened.",
     "#debug \"hello", "#debug \"hello\""},
    {Code::unterminated_comment, "unterminated-comment", "A comment without its closing */",
     "Comments in /* */ nest: each /* inside one needs a */ of its own.", "/* a /* b */\nsphere { 0, 1 }",
     "/* a /* b */ */\nsphere { 0, 1 }"},
    {Code::bad_number, "bad-number", "A number that cannot be read", "A number has at most one decimal point.",
     "sphere { 0, 1.2.3 }", "sphere { 0, 1.23 }"},
    {Code::bad_escape, "bad-escape", "An unknown escape sequence in a string",
     "In strings (not in file names) a backslash begins an escape: \\n, \\t, \\\", \\\\, \\u1234 and a few more. A "
     "backslash itself is written twice.",
     "#debug \"50 \\% done\"", "#debug \"50 % done\""},
    {Code::non_ascii, "non-ascii", "A character beyond ASCII in a string",
     "How such characters are read depends on global_settings { charset ... }; without it they become blanks.",
     "#declare S = \"gr\xc3\xbcn\";", "global_settings { charset utf8 }\n#declare S = \"gr\xc3\xbcn\";"},
    {Code::unexpected_token, "unexpected-token", "Something else was expected here",
     "The words and signs of a block have an order: the parameters of an object come first, then what modifies it. "
     "The message names what may stand here and what does.",
     "sphere { 0 radius 1 }", "sphere { 0, 1 }"},
    {Code::unclosed_block, "unclosed-block", "A block without its closing brace",
     "Every { needs a }. The message shows where the innermost open block began; if that is not the one you forgot to "
     "close, look for a closing brace that is indented less than its opening line.",
     "union {\n  sphere { 0, 1 }\n  box { 0, 1 ", "union {\n  sphere { 0, 1 }\n  box { 0, 1 }\n}"},
    {Code::unclosed_condition, "unclosed-condition", "A #if, #switch, loop or #macro without its #end",
     "#if, #ifdef, #ifndef, #switch, #while, #for and #macro all end with #end, in the same file.",
     "#if (1)\nsphere { 0, 1 }", "#if (1)\nsphere { 0, 1 }\n#end"},
    {Code::stray_branch, "stray-branch", "#else, #case, #end or #break without what they belong to",
     "There is one #end too many, or the directive that should have opened the construct is missing or commented out.",
     "sphere { 0, 1 }\n#end", "#if (1)\nsphere { 0, 1 }\n#end"},
    {Code::unknown_directive, "unknown-directive", "A # before a word that is no directive",
     "The directives are #declare, #local, #undef, #macro, #include, #if, #ifdef, #ifndef, #elseif, #else, #switch, "
     "#case, #range, #break, #while, #for, #end, #default, #version, #debug, #warning, #error, #render, #statistics, "
     "#fopen, #fclose, #read and #write.",
     "#print \"hello\"", "#debug \"hello\\n\""},
    {Code::missing_semicolon, "missing-semicolon", "A declaration without its semicolon",
     "#declare and #local of numbers, vectors, colours and calls end with a semicolon; without one the next sign of "
     "the text could belong to the value.",
     "#declare A = 1\nsphere { 0, A }", "#declare A = 1;\nsphere { 0, A }"},
    {Code::missing_hash, "missing-hash", "A directive without its #",
     "Old scenes wrote declare and include without #. It is still read, at the top level only.",
     "declare A = 1;\nsphere { 0, A }", "#declare A = 1;\nsphere { 0, A }"},
    {Code::misplaced_directive, "misplaced-directive", "A directive or macro call where none can be carried out",
     "In a few places (between the values of an array, for one) SDL reads text as it stands and carries nothing out. "
     "Parentheses around the value help.",
     "#declare A = array[1] { #if (1) 2 #end };", "#declare A = array[1] { (#if (1) 2 #end) };"},
    {Code::misplaced_keyword, "misplaced-keyword", "A keyword that belongs into another block",
     "Most keywords mean something in certain blocks only: ior in interior, roughness in finish, frequency in a "
     "pigment, normal or density. `verisim help KEYWORD` says where one may stand.",
     "sphere { 0, 1 sturm }", "sphere { 0, 1 }"},
    {Code::undeclared_identifier, "undeclared-identifier", "A name that nothing was declared as",
     "Names count upper and lower case apart; keywords are written in lower case. A name is known from its #declare "
     "on, so the order of the text matters, and one that #local made ends with its macro or include file.",
     "sphere { 0, Radius }", "#declare Radius = 1;\nsphere { 0, Radius }"},
    {Code::reserved_word, "reserved-word", "A keyword where a name of your own is needed",
     "Keywords cannot be declared, nor be macros or parameters. An upper-case letter makes a name your own.",
     "#declare height = 1;\n#declare angle = 2;", "#declare Height = 1;\n#declare Angle = 2;"},
    {Code::redeclared, "redeclared", "A name that is something else already",
     "Macros, functions and open files cannot become something else under the same name; #undef NAME frees it.",
     "#macro M() 1 #end\n#declare M = 2;", "#macro M() 1 #end\n#undef M\n#declare M = 2;"},
    {Code::no_value, "no-value", "A name that has no value yet",
     "An element of an array that nothing was assigned to, or a name inside its own first declaration.",
     "#declare A = array[2];\n#declare B = A[0];", "#declare A = array[2];\n#declare A[0] = 1;\n#declare B = A[0];"},
    {Code::deprecated, "deprecated", "Something its author advises against",
     "The declaration was marked with `#declare deprecated`; the message is the author's.",
     "#declare deprecated \"use B\" A = 1;\n#declare B = A;", "#declare B = 1;"},
    {Code::unknown_undef, "unknown-undef", "#undef of a name that is not declared",
     "Harmless, but often a misspelt name. #ifdef (NAME) #undef NAME #end says nothing.", "#undef Nothing",
     "#ifdef (Nothing) #undef Nothing #end"},
    {Code::not_an_array, "not-an-array", "Subscripts behind something that is no array",
     "Only arrays have subscripts; components of vectors are V.x, V.y, V.z.",
     "#declare V = <1, 2, 3>;\n#declare V[0] = 2;", "#declare V = <1, 2, 3>;\n#declare W = V.x;"},
    {Code::array_size, "array-size", "An array with an impossible size, or another number of values than it has",
     "array[N] { ... } needs exactly N values; sizes are at least 1, dimensions at most 5.",
     "#declare A = array[3] { 1, 2 };", "#declare A = array[2] { 1, 2 };"},
    {Code::subscript_range, "subscript-range", "A subscript outside its array",
     "Subscripts count from 0: the last of array[N] is N-1. dimension_size(A, 1) gives N.",
     "#declare A = array[2] { 1, 2 };\n#declare B = A[2];", "#declare A = array[2] { 1, 2 };\n#declare B = A[1];"},
    {Code::array_type, "array-type", "Values of different types in one array",
     "The first value decides what an array holds: numbers, vectors of three, colours, pigments ... Arrays of arrays "
     "may hold arrays of any size.",
     "#declare A = array[2] { 1, <1, 2, 3> };", "#declare A = array[2] { <1, 1, 1>, <1, 2, 3> };"},
    {Code::macro_arguments, "macro-arguments", "A macro called with another number of arguments than it has",
     "Macros have no optional arguments: a call gives all of them, separated by commas.",
     "#macro M(A, B) A*B #end\n#declare C = M(1);", "#macro M(A, B) A*B #end\n#declare C = M(1, 2);"},
    {Code::function_arguments, "function-arguments", "A function called with another number of arguments than it has",
     "function { ... } without a parameter list has the parameters x, y and z.",
     "#declare F = function(a, b) { a*b };\n#declare C = F(1);",
     "#declare F = function(a, b) { a*b };\n#declare C = F(1, 2);"},
    {Code::function_syntax, "function-syntax", "Something a user function cannot contain",
     "Inside function { ... } stand floats only: numbers, parameters, identifiers that hold a float, other functions, "
     "and components of vector-valued calls.",
     "#declare F = function(n) { select(n-1, 1, 1, n*F(n-1)) };", "#declare F = function(n) { n*n };"},
    {Code::wrong_type, "wrong-type", "A value of another kind than is needed here",
     "A string where a number is needed, a texture where a pigment is, and the like. The message names the identifier "
     "and what it holds.",
     "#declare S = \"one\";\nsphere { 0, S }", "#declare S = 1;\nsphere { 0, S }"},
    {Code::wrong_terms, "wrong-terms", "A vector with another number of components than is needed here",
     "A single number may stand for a vector (all components are equal), never the reverse: take a component with .x, "
     ".y or .z.",
     "#declare P = <1, 2, 3>;\nsphere { 0, P }", "#declare P = <1, 2, 3>;\nsphere { 0, P.x }"},
    {Code::divide_by_zero, "divide-by-zero", "A division by zero",
     "The result is infinite, and so is most of what is made of it. Test the divisor with #if before.",
     "#declare N = 0;\n#declare A = 1/N;", "#declare N = 2;\n#declare A = 1/N;"},
    {Code::domain_error, "domain-error", "A mathematical function asked for what it does not have",
     "sqrt and log of negative numbers, acos and asin beyond 1: guard the argument with max, min or select.",
     "#declare A = ln(0);", "#declare A = ln(1);"},
    {Code::bad_value, "bad-value", "A value that is not allowed here", "The message says which values are.",
     "camera { angle 200 }\nsphere { 0, 1 }", "camera { angle 60 }\nsphere { 0, 1 }"},
    {Code::adjusted_value, "adjusted-value", "A value that is replaced by one that can be used",
     "The picture is made with the value that the message names, as POV-Ray does it; the text should say what is "
     "meant.",
     "sphere { 0, 1 scale <1, 0, 1> }", "sphere { 0, 1 scale <1, 0.001, 1> }"},
    {Code::degenerate, "degenerate", "An object that has shrunk to nothing",
     "Two ends in the same place, a triangle with two equal corners, a plane without a direction: often a wrong sign, "
     "or a variable that is still 0.",
     "cylinder { 0, 0, 1 }", "cylinder { 0, y, 1 }"},
    {Code::too_few, "too-few", "A list that is shorter than what is made of it needs",
     "Splines need points beyond their ends: a linear prism or lathe needs the fewest, a cubic one two more.",
     "lathe { linear_spline 1, <1, 0> }", "lathe { linear_spline 2, <1, 0>, <1, 1> }"},
    {Code::too_many, "too-many", "A list that is longer than it can be", "The message names the limit.",
     "#declare V = <1, 2, 3, 4, 5, 6>;", "#declare V = <1, 2, 3, 4, 5>;"},
    {Code::not_closed, "not-closed", "An outline whose last point is not its first",
     "Polygons and prisms are closed outlines: repeat the first point at the end of each.",
     "polygon { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }", "polygon { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> }"},
    {Code::missing_item, "missing-item", "A block without something it needs",
     "The message names what is missing: the map of a pattern, the type of a normal, the function of an isosurface.",
     "sphere { 0, 1 pigment { average } }",
     "sphere { 0, 1 pigment { average pigment_map { [1 color rgb 1] [1 color rgb 0] } } }"},
    {Code::incompatible, "incompatible", "Two things that cannot be used together",
     "The message names both; the second is usually the one to take out.",
     "sphere { 0, 1 texture { pigment { color rgb 1 } } uv_mapping }",
     "sphere { 0, 1 uv_mapping texture { pigment { color rgb 1 } } }"},
    {Code::duplicate, "duplicate", "Something that counts once and stands twice",
     "The last one is used; the other can be removed.", "camera { location z }\ncamera { location x }\nsphere { 0, 1 }",
     "camera { location x }\nsphere { 0, 1 }"},
    {Code::no_effect, "no-effect", "Something that changes nothing", "It can be removed.",
     "sphere { 0, 1 color rgb 1 }", "sphere { 0, 1 pigment { color rgb 1 } }"},
    {Code::discontinued, "discontinued", "An old form that is kept for old scenes",
     "The message names the new form; the old one still works.", "#declare C = color rgb 1 alpha 0.5;",
     "#declare C = color rgb 1 transmit 0.5;"},
    {Code::experimental, "experimental", "A feature that POV-Ray calls experimental",
     "It works; a later version may do it otherwise.",
     "#declare S = spline { linear_spline 0, <0, 0, 0> 1, <1, 1, 1> };", ""},
    {Code::missing_include, "missing-include", "An include file that is not there",
     "Include files are looked for in the current folder, in the library folders (+L, VERISIM_INCLUDE_PATH, the "
     "standard ones of POV-Ray's package povray-includes) and beside the scene. On Linux upper and lower case differ, "
     "and folders are separated by /.",
     "#include \"no such file.inc\"", ""},
    {Code::missing_file, "missing-file", "A picture, font or data file that is not there",
     "It is looked for where include files are. On Linux upper and lower case differ, and folders are separated by /.",
     "text { ttf \"no such font.ttf\" \"A\" 1, 0 }", ""},
    {Code::file_access, "file-access", "A file that the scene may not read or write",
     "Scenes write below the current folder and their own only; --allow-write PATH and --allow-read PATH permit more.",
     "", ""},
    {Code::file_failed, "file-failed", "A file that could not be read or written",
     "The system's reason is in the message: permissions, a full disk, a folder in the place of a file.", "", ""},
    {Code::bad_file, "bad-file", "A file whose content is not what it should be",
     "The file was found and could not be understood; the message names the place, or the kind that was expected.", "",
     ""},
    {Code::missing_version, "missing-version", "A scene that does not say which version of SDL it is written in",
     "Without #version the rules of version 3.62 hold, under which colours are not corrected for gamma. A new scene "
     "begins with #version 3.7;",
     "", ""},
    {Code::late_version, "late-version", "A #version that is not the first statement",
     "What stands before it is read by the rules of another version.", "", ""},
    {Code::version_limits, "version-limits", "A version of SDL that is not wholly known",
     "Later versions than 3.7 have features that this program does not know; the oldest ones have oddities that nobody "
     "misses.",
     "#version 4.5;", "#version 3.7;"},
    {Code::missing_gamma, "missing-gamma", "A scene without assumed_gamma",
     "global_settings { assumed_gamma 1.0 } says that the scene's colours are linear light, which is what the formulas "
     "of light need. Without it 1.0 is taken from version 3.7 on; before that colours are not corrected at all.",
     "", ""},
    {Code::no_objects, "no-objects", "A scene that contains nothing to see",
     "Every object is inside an #if that is not taken, declared but never used, or commented out.",
     "background { color rgb 1 }", "sphere { 0, 1 }"},
    {Code::no_camera, "no-camera", "A scene without a camera",
     "POV-Ray then looks from the origin along z, with the image's aspect ratio. An include file that has only "
     "declarations, rendered by mistake, gives this message, too.",
     "", ""},
    {Code::no_light, "no-light", "A scene without light",
     "There is no light_source, nothing with an emission or ambient of its own beyond the default, and no radiosity: "
     "what is seen stays nearly black.",
     "", ""},
    {Code::camera_inside, "camera-inside", "The camera is inside an opaque object",
     "The picture shows that object's inside, which no light reaches: it is black. Move location out, or make the "
     "object hollow or the hole in it larger.",
     "", ""},
    {Code::user_error, "user-error", "The scene stops itself by #error", "The text is the scene's own.",
     "#error \"stop\"", ""},
    {Code::user_warning, "user-warning", "The scene warns by #warning", "The text is the scene's own.",
     "#warning \"careful\"", ""},
    {Code::nesting_limit, "nesting-limit", "Nested more deeply than the limit",
     "Usually a macro or function that calls itself without end; --max-depth raises the limit.",
     "#macro M() M() #end\nM()", ""},
    {Code::size_limit, "size-limit", "More than a limit allows",
     "Limits keep a scene from taking all of the machine: --max-memory, --max-tokens, --max-file-bytes, --max-steps "
     "raise them. The message names the one that was met.",
     "#declare A = array[100000][100000][100000];", ""},
    {Code::time_limit, "time-limit", "The scene took longer than --max-seconds, or was interrupted",
     "A loop that never ends is the usual reason.", "", ""},
    {Code::unsupported, "unsupported", "A feature that verisim does not have",
     "The scene is right; verisim cannot render it. Exit status 4.", "", ""},
    {Code::internal, "internal", "An error that has no better name",
     "The message comes from the system or from a library.", "", ""},
};
static_assert(std::size(kCodes) == static_cast<std::size_t>(Code::count));
static_assert([] {
  for (std::size_t i = 0; i < std::size(kCodes); ++i)
    if (kCodes[i].code != static_cast<Code>(i)) return false;
  return true;
}());

// Breaks text into lines of at most 100 characters.
std::string filled(std::string_view text) {
  std::string out;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (column && column + 1 + end > 100) out += '\n', column = 0;
    if (column) out += ' ', ++column;
    out += text.substr(0, end);
    column += end;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out + '\n';
}

std::string indented(std::string_view text) {
  std::string out = "    ";
  for (const char c : text) {
    out += c;
    if (c == '\n') out += "    ";
  }
  return out + '\n';
}

}  // namespace

std::span<const CodeEntry> all_codes() { return kCodes; }
const CodeEntry& entry(Code code) { return kCodes[static_cast<std::size_t>(code)]; }
std::string_view name(Code code) { return entry(code).name; }

std::optional<Code> code_named(std::string_view name) {
  for (const CodeEntry& e : kCodes)
    if (e.name == name) return e.code;
  return std::nullopt;
}

std::string explanation(const CodeEntry& e) {
  std::string out = std::string(e.name) + ": " + std::string(e.title) + "\n\n" + filled(e.text);
  if (!e.wrong.empty()) out += "\nThis gives it:\n\n" + indented(e.wrong);
  if (!e.right.empty()) out += "\nThis does not:\n\n" + indented(e.right);
  return out;
}

}  // namespace verisim::parser
