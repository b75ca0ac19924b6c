export { ruleLabel } from './rule-values.ts';
