import './parts.css';

export { FolderSelect, Offer, PlayButton, SamplesButton } from './Offer.tsx';
export { Facts, OutcomeSign, outcomeWord, Progress, Section, Segments } from './Section.tsx';
export { TextDialog } from './TextDialog.tsx';
