export { AccuracyPanel } from './AccuracyPanel.tsx';
export { OtherAccuracy } from './OtherAccuracy.tsx';
