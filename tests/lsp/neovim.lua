-- Drives `verisim lsp` through Neovim's own client: nvim --headless --clean -l is newer than Debian 12, so -S.
-- NEOVIM_SERVER: the program; NEOVIM_SCENE: a scene with one mistake in line 3; NEOVIM_RESULT: where the answers go.
local result = {}
local function finish(status)
  vim.fn.writefile({ vim.fn.json_encode(result) }, vim.env.NEOVIM_RESULT)
  vim.cmd(status == 0 and "qall!" or "cquit!")
end
vim.cmd("edit " .. vim.fn.fnameescape(vim.env.NEOVIM_SCENE))
local buffer = vim.api.nvim_get_current_buf()
local client = vim.lsp.start_client({ name = "verisim", cmd = { vim.env.NEOVIM_SERVER, "lsp" }, root_dir = vim.fn.getcwd() })
if not client or not vim.lsp.buf_attach_client(buffer, client) then
  result.error = "no client"
  finish(1)
end
if not vim.wait(20000, function() return #vim.diagnostic.get(buffer) > 0 end, 20) then
  result.error = "no diagnostics"
  finish(1)
end
local first = vim.diagnostic.get(buffer)[1]
result.diagnostic = { line = first.lnum, column = first.col, message = first.message }
local function ask(method, line, column)
  local answers = vim.lsp.buf_request_sync(buffer, method, {
    textDocument = vim.lsp.util.make_text_document_params(buffer), position = { line = line, character = column } }, 5000)
  local answer = answers and answers[client]
  return answer and answer.result
end
local hover = ask("textDocument/hover", 1, 3)
result.hover = hover and hover.contents.value
-- Mending the mistake takes it back.
vim.api.nvim_buf_set_lines(buffer, 2, 3, false, { "sphere { 0, 1 }" })
result.mended = vim.wait(20000, function() return #vim.diagnostic.get(buffer) == 0 end, 20)
vim.lsp.stop_client(client)
finish(0)
