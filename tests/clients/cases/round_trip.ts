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
const rows = answered(await sigcat.listNodes({ path: { catalogue }, query: { fields: 'path,unit', limit: 3 } })).rows;
assert.equal(rows[0]!['path'], tree.path);
const page = answered(await sigcat.searchNodes({ path: { catalogue }, query: { q: 'wheel speed', limit: 5 } }));
const found = page.hits[0]!.path;
const node = answered(await sigcat.getNode({ path: { catalogue, path: found } }));
assert.deepEqual([node.path, node.datatype, node.unit], [found, page.hits[0]!.datatype, page.hits[0]!.unit]);
const missing = await sigcat.getNode({ path: { catalogue, path: 'Vehicle.Sped' } });
assert((missing.error as sigcat.Problem).nearest.length > 0);

const report = answered(await sigcat.lint({ body: file('Vehicle.Speed:\n  type: sensr\n') }));
assert.equal(report.findings[0]!.line, 2);
assert.equal(report.finding_counts.errors, report.findings.filter((each) => each.severity === 'error').length);
const overlay = file('Vehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: km/h\n  max: 100\n');
const trial = answered(await sigcat.tryOverlay({ path: { catalogue }, body: overlay }));
assert.equal(trial.changes[0]!.path, 'Vehicle.Speed');
const diff = answered(await sigcat.diffCatalogues({ path: { catalogue: 'vss' }, query: { to: catalogue } }));
assert.equal(diff.summary.total, diff.changes.length);

const query: sigcat.ExportRos2InterfaceData['query'] = { mode: 'leaf', topics: ['Vehicle.Speed'] };
assert('Vehicle' in answered(await sigcat.exportJson({ path: { catalogue }, query: { pretty: true } })));
assert(answered(await sigcat.exportCsv({ path: { catalogue } })).startsWith('Signal,'));
assert((await answered(await sigcat.exportYaml({ path: { catalogue } })).text()).startsWith('Vehicle'));
assert(answered(await sigcat.exportRos2Interface({ path: { catalogue }, query })).size > 0);

const text = file(readFileSync(declaration));
const built = answered(await sigcat.buildFunctionJson({ body: text, query: { catalogue } }));
assert(answered(await sigcat.validateFunction({ body: file(JSON.stringify(built)) })).ok);
const integrated = answered(await sigcat.integrateFunctions({ path: { platform: 'autosar-adaptive' }, body: text }));
const arxml = answered(await sigcat.generateArxml({ body: file(JSON.stringify(integrated)) }));
assert.equal((await arxml.text()).slice(0, 2), 'PK');
const application = answered(await sigcat.generateAutosarAdaptive({ body: file(JSON.stringify(integrated)), query: { bench: true } }));
assert.equal((await application.text()).slice(0, 2), 'PK');
const classic = answered(await sigcat.integrateFunctions({ path: { platform: 'autosar-classic' }, body: text }));
const classicArxml = answered(await sigcat.generateClassicArxml({ body: file(JSON.stringify(classic)) }));
assert.equal((await classicArxml.text()).slice(0, 2), 'PK');
const forRos = answered(await sigcat.integrateFunctions({ path: { platform: 'ros2' }, body: text }));
const packages = answered(await sigcat.generateRos2({ body: file(JSON.stringify(forRos)), query: { distribution: 'humble' } }));
assert.equal((await packages.text()).slice(0, 2), 'PK');

const receipt = answered(await sigcat.publishVersions({ body: text, query: { catalogue } }));
const { name, versionid } = receipt.versions_posted[0]!;
const of = { group: 'functions', name, version: versionid } as const;
const content = answered(await sigcat.getVersionContent({ path: of, parseAs: 'text' }));
assert.equal(content as unknown, readFileSync(declaration, 'utf-8'));
const version = answered(await sigcat.getRegistryVersion({ path: of, query: { inline: 'uses' } }));
assert.equal(answered(await sigcat.listRegistryNames({ path: { group: 'functions' } })).total, 1);
const users = answered(await sigcat.listRegistryUsers({ query: { path: version.uses![0]!.element } }));
assert.equal(users.users[0]!.name, name);
const asked = { function: `${name}@${versionid}`, line: 'SUV-2025' };
assert(answered(await sigcat.recordDeployment({ query: asked })));
assert.equal(answered(await sigcat.canDeploy({ query: asked })).decision, 'yes');
assert(answered(await sigcat.checkVersions({ body: text, query: { catalogue } })).ok);
