"""The paper of Lasram and Lefebvre (2012), section 8, on our exemplars."""
