export { AttemptsPanel } from './AttemptsPanel.tsx';
export { AttemptsWatch } from './AttemptsWatch.tsx';
