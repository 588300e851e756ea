// The round trip of a generated TypeScript client: node round_trip.js ADDRESS DECLARATION. Type-checked, then run.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { client } from './client/client.gen.js';
import * as sigcat from './client/index.js';

const [address, declaration] = process.argv.slice(2) as [string, string];
client.setConfig({ baseUrl: address });

const file = (data: BlobPart): Blob => new Blob([data]);

function answered<T>(result: { data?: T; error?: unknown }): T {
  if (result.data === undefined) throw new Error(JSON.stringify(result.error));
  return result.data;
}

const listed = answered(await sigcat.listCatalogues());
const catalogue = listed.catalogues[0]!.id;

const tree = answered(await sigcat.getTree({ path: { catalogue }, query: { depth: 2 } }));
assert(tree.subtrees!.length > 0);
const page = answered(await sigcat.searchNodes({ path: { catalogue }, query: { q: 'wheel speed', limit: 5 } }));
const found = page.hits[0]!.path;
const node = answered(await sigcat.getNode({ path: { catalogue, path: found } }));
assert.equal(node.path, found);
const missing = await sigcat.getNode({ path: { catalogue, path: 'Vehicle.Sped' } });
assert((missing.error as sigcat.Problem).nearest.length > 0);

const report = answered(await sigcat.lint({ body: file('Vehicle.Speed:\n  type: sensr\n') }));
assert.equal(report.findings[0]!.line, 2);
const overlay = file('Vehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: km/h\n  max: 100\n');
const trial = answered(await sigcat.tryOverlay({ path: { catalogue }, body: overlay }));
assert.equal(trial.changes[0]!.path, 'Vehicle.Speed');
const diff = answered(await sigcat.diffCatalogues({ path: { catalogue: 'vss' }, query: { to: catalogue } }));
assert.equal(diff.summary.total, diff.changes.length);

const text = file(readFileSync(declaration));
const built = answered(await sigcat.buildFunctionJson({ body: text, query: { catalogue } }));
assert(answered(await sigcat.validateFunction({ body: file(JSON.stringify(built)) })).ok);
const integrated = answered(await sigcat.integrateFunctions({ path: { platform: 'autosar-adaptive' }, body: text }));
const arxml = answered(
  await sigcat.generateArxml({ body: file(JSON.stringify(integrated)), parseAs: 'arrayBuffer' }),
) as unknown as ArrayBuffer;
assert.equal(Buffer.from(arxml).subarray(0, 2).toString(), 'PK');
