export { Inspector } from './Inspector.tsx';
export { ruleLabel, ruleValues } from './rule-values.ts';
