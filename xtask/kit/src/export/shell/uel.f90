module jp_uel_{id}
    use jp_runtime, only: dp
    use jp_element_{id}_smooth
    {use_rubbing}
    implicit none
    private
    public :: uel_{id}
contains
    subroutine uel_{id}(rhs, amatrx, svars, ndofel, props, coords, mcrd, u, lflags, mlvarx, pnewdt)
        integer, intent(in) :: ndofel, mcrd, mlvarx, lflags(*)
        real(dp), intent(in) :: props(*), coords(mcrd, *), u(ndofel)
        real(dp), intent(inout) :: rhs(mlvarx, *), amatrx(ndofel, ndofel), svars(*), pnewdt
        integer, parameter :: motions = {motions}, all_motions = {ndofel}
        {declarations}
        logical :: is_well
        integer :: code

        if (.not. keeps_order()) then
            error stop 'UEL: compile with -fp-model precise'
        end if
        rhs(:all_motions, 1) = 0
        amatrx(:all_motions, :all_motions) = 0
        ! Residual and stiffness, stiffness alone, residual alone; no mass and no damping.
        if (lflags(3) /= 1 .and. lflags(3) /= 2 .and. lflags(3) /= 5) return
        {nodes}
        {call}
        is_well = code == 0
        {finite}
        if (.not. is_well) then
            pnewdt = min(pnewdt, 0.5_dp)
            return
        end if
        if (lflags(3) /= 2) then
            rhs(:motions, 1) = forces
            {conditions}
        end if
        if (lflags(3) == 5) return
        amatrx(:motions, :motions) = -stiffness
        {matrices}
    end subroutine uel_{id}
{functions}end module jp_uel_{id}
