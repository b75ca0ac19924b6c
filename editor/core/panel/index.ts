export { fetched, laterCover, laterPanel, loadParts } from './later.tsx';
export { FolderSelect, Offer, PlayButton, SamplesButton } from './offers.tsx';
export { Facts, OutcomeSign, outcomeWord, Progress, Section, Segments } from './parts.tsx';
export { TextDialog } from './TextDialog.tsx';
