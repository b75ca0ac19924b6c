import './parts.css';

export { Facts } from './Facts.tsx';
export { PlayButton } from './PlayButton.tsx';
export { Progress } from './Progress.tsx';
export { Section } from './Section.tsx';
export { Segments } from './Segments.tsx';
