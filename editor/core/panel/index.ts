import './parts.css';

export { Facts } from './Facts.tsx';
export { FolderSelect } from './FolderSelect.tsx';
export { Offer } from './Offer.tsx';
export { OutcomeSign, outcomeWord } from './OutcomeSign.tsx';
export { PlayButton } from './PlayButton.tsx';
export { Progress } from './Progress.tsx';
export { SamplesButton } from './SamplesButton.tsx';
export { Section } from './Section.tsx';
export { Segments } from './Segments.tsx';
export { TextDialog } from './TextDialog.tsx';
