// Directives and what belongs to them.
#include "parser/keywords/keywords.h"

namespace verisim::parser {
namespace {

constexpr Keyword kDirectiveWords[] = {
    {"append", "+fopen", "#fopen HANDLE \"file\" append", "",
     "Opens the file for writing at its end; what is there stays."},
    {"array", "value", "array[N]...[ { ITEM, ... } ]", "",
     "A table of values of one kind with 1 to 5 dimensions, read as NAME[i]; indices count from 0. Items in braces "
     "fill it, nested by dimension."},
    {"break", "#", "#break", "", "Leaves the innermost #while or #for, or ends a #case or #range."},
    {"case", "#", "#case (NUMBER)", "",
     "Within #switch: what follows is executed when the value equals this number, up to #break or #end."},
    {"debug", "#", "#debug STRING", "", "Prints the text to the debug stream."},
    {"declare", "# scene", "#declare NAME = VALUE;", "",
     "Gives an identifier a value that holds from here to the end of the scene, in all files. Numbers, vectors, "
     "colours and strings end with a semicolon; blocks need none."},
    {"default", "# scene", "#default { ITEM ... }", "",
     "As #default: sets the pigment, normal, finish, texture, camera or radiosity that later statements start from. "
     "Within #switch: the branch for all other values."},
    {"deprecated", "+declare", "#declare deprecated [once] [\"message\"] NAME = VALUE;", "",
     "Marks an identifier: using it gives a warning, with this message if there is one."},
    {"else", "#", "#else", "",
     "What is executed when no condition before it held, up to #end; within #switch: no case before it."},
    {"elseif", "#", "#elseif (CONDITION)", "",
     "A further branch of #if: executed when its condition is the first that holds."},
    {"end", "#", "#end", "", "Ends #if, #ifdef, #ifndef, #while, #for, #switch or #macro."},
    {"error", "#", "#error STRING", "", "Prints the text and ends the render with an error."},
    {"fclose", "#", "#fclose HANDLE", "", "Closes a file that #fopen opened."},
    {"fopen", "#", "#fopen HANDLE \"file\" read|write|append", "",
     "Opens a text file of values and gives it a name for #read, #write and #fclose."},
    {"for", "#", "#for (NAME, START, END [, STEP]) ... #end", "step 1",
     "Repeats its body while NAME runs from START to END, both included. NAME is a #local variable."},
    {"if", "#", "#if (CONDITION) ... [#elseif (CONDITION) ...] [#else ...] #end", "",
     "Executes what follows when the condition is not 0. It may stand anywhere, even within a vector."},
    {"ifdef", "#", "#ifdef (NAME) ... [#else ...] #end", "",
     "Executes what follows when the identifier, or element of an array, has a value."},
    {"ifndef", "#", "#ifndef (NAME) ... [#else ...] #end", "",
     "Executes what follows when the identifier has no value: for include files that should be read once, and for "
     "values that the caller may set."},
    {"include", "# scene", "#include \"file\"", "",
     "Reads another file here, as if it were written in this place. It is looked for in the current folder, then in "
     "the library paths (+L), then where POV-Ray's include files are."},
    {"local", "#", "#local NAME = VALUE;", "",
     "Like #declare, but the identifier ends with the macro or file that it is written in."},
    {"macro", "#", "#macro NAME (PARAMETER, ...) ... #end", "",
     "Names a piece of SDL that is executed wherever NAME(ARGUMENTS) stands. It may yield a value, a part of a block "
     "or whole statements. Parameters stand for the arguments; assigning one with #declare changes the caller's "
     "variable."},
    {"once", "+deprecated", "#declare deprecated once NAME = VALUE;", "",
     "The warning about a deprecated identifier is given at its first use only."},
    {"range", "#", "#range (LOW, HIGH)", "",
     "Within #switch: executed when the value lies between the two, both included."},
    {"read", "#", "#read (HANDLE, NAME, ...)", "",
     "Reads values, separated by commas, from a file into identifiers. defined(HANDLE) becomes false at the file's "
     "end."},
    {"read", "+fopen", "#fopen HANDLE \"file\" read", "", "Opens the file for reading."},
    {"render", "#", "#render STRING", "", "Prints the text to the render stream."},
    {"sint16be", "+write", "#write (HANDLE, sint16be VALUE, ...)", "",
     "Writes integers from -32768 to 32767 as two bytes, the high one first."},
    {"sint16le", "+write", "#write (HANDLE, sint16le VALUE, ...)", "",
     "Writes integers from -32768 to 32767 as two bytes, the low one first."},
    {"sint32be", "+write", "#write (HANDLE, sint32be VALUE, ...)", "",
     "Writes integers with sign as four bytes, the highest first."},
    {"sint32le", "+write", "#write (HANDLE, sint32le VALUE, ...)", "",
     "Writes integers with sign as four bytes, the lowest first."},
    {"sint8", "+write", "#write (HANDLE, sint8 VALUE, ...)", "", "Writes integers from -128 to 127 as one byte each."},
    {"statistics", "#", "#statistics STRING", "", "Prints the text to the statistics stream."},
    {"switch", "#", "#switch (VALUE) #case (N) ... #break #range (A, B) ... #break #else ... #end", "",
     "Executes the branch whose #case or #range fits the value. Without #break it goes on into the next one."},
    {"uint16be", "+write", "#write (HANDLE, uint16be VALUE, ...)", "",
     "Writes integers from 0 to 65535 as two bytes, the high one first."},
    {"uint16le", "+write", "#write (HANDLE, uint16le VALUE, ...)", "",
     "Writes integers from 0 to 65535 as two bytes, the low one first."},
    {"uint8", "+write", "#write (HANDLE, uint8 VALUE, ...)", "",
     "Writes integers from 0 to 255 as one byte each: for DF3 files and the like."},
    {"undef", "#", "#undef NAME", "", "Forgets an identifier."},
    {"version", "#", "#version 3.7;", "3.62 until it is written",
     "Says which version of POV-Ray the scene was written for: it decides defaults, gamma handling and some syntax. "
     "Put it first."},
    {"version", "expression", "version", "", "The language version in force, such as 3.7."},
    {"warning", "#", "#warning STRING", "", "Prints the text as a warning and goes on."},
    {"while", "#", "#while (CONDITION) ... #end", "", "Repeats its body as long as the condition is not 0."},
    {"write", "#", "#write (HANDLE, VALUE, ...)", "",
     "Writes numbers, vectors and strings to a file that #fopen opened. Strings are written as they are: write the "
     "commas and line ends yourself if #read shall read it."},
    {"write", "+fopen", "#fopen HANDLE \"file\" write", "", "Makes the file, or empties it, for writing."},
};

}  // namespace

const KeywordSection kDirectives{
    "Directives", "directives",
    "A directive begins with `#`, may stand anywhere, even in the middle of a vector, and is executed when the reader "
    "gets there. A scene is a program: what it yields is a list of objects and settings.",
    kDirectiveWords};

}  // namespace verisim::parser
