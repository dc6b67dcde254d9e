// Generates src/gen, or the folder given, from the contract with protoc (grpcio-tools) and protoc-gen-es.
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const web = resolve(dirname(fileURLToPath(import.meta.url)), "..");
const contract = resolve(web, "../twin/bumpless/contract");
const venv = resolve(web, "../.venv/bin/python");
const python = process.env.PYTHON ?? (existsSync(venv) ? venv : "python3");
const out = resolve(process.argv[2] ?? join(web, "src/gen"));
mkdirSync(out, { recursive: true });

const run = spawnSync(
  python,
  [
    "-m",
    "grpc_tools.protoc",
    `--plugin=protoc-gen-es=${join(web, "node_modules/.bin/protoc-gen-es")}`,
    `--es_out=${out}`,
    "--es_opt=target=ts",
    `-I${contract}`,
    join(contract, "bumpless.proto"),
  ],
  { stdio: "inherit" },
);
process.exit(run.status ?? 1);
