export { type Ci, chooseCi } from './ci.ts';
export { planProject } from './plan-project.ts';
