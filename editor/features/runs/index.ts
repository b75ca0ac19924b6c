export { OutcomeSign } from './OutcomeSign.tsx';
export { RunsPanel } from './RunsPanel.tsx';
export { useRunEnds } from './run-ends.ts';
export { SCRIPT_FIELD } from './ScriptField.tsx';
