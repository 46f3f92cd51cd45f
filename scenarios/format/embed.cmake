# cmake -DNAME=symbol -DIN=file -DOUT=file.cpp -P embed.cmake: a text file as `extern const std::string_view` of cusp::embedded.
file(READ "${IN}" TEXT)
file(WRITE "${OUT}" "#include <string_view>\n\nnamespace cusp::scenarios::embedded {\nextern const std::string_view ${NAME};\nconst std::string_view ${NAME} = R\"cusp(${TEXT})cusp\";\n}  // namespace cusp::scenarios::embedded\n")
