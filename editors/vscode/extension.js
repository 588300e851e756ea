// Start `sigcat lsp`, and connect it with the editor.

const { workspace } = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

const NAMES = "**/{sigcat.toml,function.yaml,*.function.yaml,units.yaml,quantities.yaml,*rules*.yaml}";
let client;

function activate() {
  const [command, ...args] = workspace.getConfiguration("sigcat").get("command");
  const options = { cwd: workspace.workspaceFolders?.[0]?.uri.fsPath };
  client = new LanguageClient("sigcat", "sigcat", { command, args, options }, {
    documentSelector: [{ scheme: "file", language: "vspec" }, { scheme: "file", pattern: NAMES }],
    synchronize: { fileEvents: workspace.createFileSystemWatcher("**/*.{vspec,yaml,toml,h,c}") },
  });
  return client.start();
}

function deactivate() {
  return client?.stop();
}

module.exports = { activate, deactivate };
