// What options and reports need of the schema. The schema itself loads zod, which takes as long as starting node.
export { closestName } from '../closest-name.ts';
export { touchedName } from '../names.ts';
export { MAX_FILE_SIZE } from '../read-json.ts';
