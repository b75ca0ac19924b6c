export { type Ci, chooseCi } from './ci.ts';
export { type Plan, planProject } from './plan-project.ts';
